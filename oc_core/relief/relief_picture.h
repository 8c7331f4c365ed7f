// Pictures of relief tiles among other geometry, with a z-buffer and shadows (section 3.5.2.3.2).
//
// The box of each tile is drawn, from near to far; each of its pixels' rays is moved into the coordinates of the tile
// and intersected with the tile's object. Depth is compared with that of the other geometry and of the tiles before, so
// all meet each other as they should. Shadows are a second ray from what is seen to the sun, at the same tiles and the
// same geometry.
//
// DEVIATION: the text prefers a shadow map. A second ray has no resolution of its own that would have to be chosen, so
// that shadows compare with traced ones; the text names it as the other way.
#pragma once

#include <memory>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/relief/relief_scene.h"
#include "oc_core/relief/surface_labels.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

/// Geometry that rays meet as it is, without baked light.
class PlainGeometry {
 public:
  explicit PlainGeometry(const Mesh& mesh) : labels_(mesh), rays_(labels_.mesh()) {}
  /// It stays where it is: rays refer to its mesh.
  PlainGeometry(const PlainGeometry&) = delete;
  PlainGeometry& operator=(const PlainGeometry&) = delete;

  const SurfaceLabels& labels() const { return labels_; }
  const RayScene& rays() const { return rays_; }

 private:
  SurfaceLabels labels_;
  RayScene rays_;
};

/// What a picture shows.
struct ReliefPicture {
  static constexpr int32_t kNothing = -1;   ///< the background
  static constexpr int32_t kGeometry = -2;  ///< what is no tile

  Image<int32_t> shown;             ///< the number of the tile, or one of those above
  Image<uint32_t> triangle;         ///< of what is no tile; of no meaning elsewhere
  Image<float> z;                   ///< along the view direction; 0 where nothing is shown
  Image<glm::vec3> point;           ///< in the world; of no meaning there
  Image<glm::vec3> color;           ///< linear, with light and shadow
  Image<uint8_t> inShadow;          ///< 1 where the sun does not reach what faces it
  RayCost cost;                     ///< of rays from the eye
  size_t rays = 0;                  ///< pixels of boxes, summed over tiles: those rays
  double geometryMilliseconds = 0;  ///< of the eye rays to what is no tile
  double milliseconds = 0;          ///< of tiles, from the eye: boxes, intersections, depth
  double cpuMilliseconds = 0;       ///< the same, of the CPU time of this process, all threads together
  double shadowMilliseconds = 0;    ///< of the rays to the sun
};

struct ReliefDrawing {
  int runs = 1;  ///< times are the least of them
  bool shadows = true;
};

class ReliefRenderer {
 public:
  /// `around` may be null.
  ReliefRenderer(std::shared_ptr<const ReliefScene> tiles, std::shared_ptr<const PlainGeometry> around);

  /// On all threads; the same with any number of them.
  ReliefPicture draw(const PinholeCamera& camera, const ReliefDrawing& how = {}) const;
  /// The same picture, ray by ray at every tile and every cell: what tests compare with. Without shadows.
  ReliefPicture drawSlowly(const PinholeCamera& camera) const;

  const ReliefScene& tiles() const { return *tiles_; }

 private:
  std::shared_ptr<const ReliefScene> tiles_;
  std::shared_ptr<const PlainGeometry> around_;
};

}  // namespace ocelli
