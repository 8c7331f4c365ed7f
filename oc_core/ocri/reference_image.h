// The reference image: one layer of samples, each with colour, depth and the displacement that unprojects it
// (section 3.2.3). Built with an occlusion camera it is the OCRI of section 3.5.5; built with the pinhole itself, the
// depth image (DI).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/camera/gpc_layout.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

class SceneRenderer;

/// How the rows of a reference image lie beside each other.
enum class ImageRows {
  kAligned,      ///< the sample below one of its own surface lies below it, or nearly
  kShifted,      ///< rows are epipolar lines, and each is stretched by itself (section 3.3)
  kShiftedRing,  ///< the same, and the last row is next to the first: epipolar lines around a point in the image
};

struct ReferenceImage {
  std::string camera;  ///< "di", "ddoc", ...
  View view;           ///< of the reference pinhole
  Image<glm::vec3> color;
  /// The parameter of the ray at each sample (camera.h): z, but in images that displace no pinhole's. 0 where there is
  /// no sample.
  Image<float> t;
  Image<uint8_t> held;            ///< whether the pixel holds a sample: 1 or 0
  Image<glm::vec2> displacement;  ///< (d_u, d_v), pixels: where the sample is minus where the pinhole sees it
  /// Triangles of the depth image's mesh for the same view: an OCRI's mesh keeps to it. 0 where there is no bound.
  size_t triangleBound = 0;
  /// Width and height of the reference pinhole, where they are not those of the image.
  glm::ivec2 pinholeSize{0};
  ImageRows rows = ImageRows::kAligned;
  int layer = 0;  ///< of a layered depth image: one above 0 lies behind the image that comes before it in the union
  /// Where not 0: the rows below the pinhole's height hold square tiles of this side that have nothing to do with their
  /// neighbours.
  int tileSide = 0;
  float tileSpacing = 1;  ///< between neighbouring samples in tiles, pixels of the reference pinhole
  /// Its mesh is also looked at from other sides, where what stands out along its rays is seen.
  bool seenFromAside = false;
  /// Of an image that displaces no pinhole's (placed_image.h): where each sample is, world coordinates, and the way of
  /// its ray there, a unit vector. There is no displacement then. Empty otherwise.
  Image<glm::vec3> position = {};
  Image<glm::vec3> direction = {};
  /// Of a pinhole whose samples lie more densely in places (gpc_camera.h): without regions, of one like all others.
  GpcLayout layout{.regions = {}};
  bool wrapsAround = false;  ///< the last column is next to the first

  int width() const { return t.width(); }
  int height() const { return t.height(); }
  bool holds(int x, int y) const { return held(x, y) != 0; }
  bool holds(size_t pixel) const { return held[pixel] != 0; }
  void set(int x, int y, float parameter, const glm::vec3& linearColor) {
    t(x, y) = parameter;
    held(x, y) = 1;
    color(x, y) = linearColor;
  }
  void clear(size_t pixel) {
    t[pixel] = 0;
    held[pixel] = 0;
  }
  PinholeCamera reference() const {
    return pinholeSize.x > 0 ? PinholeCamera{view, pinholeSize.x, pinholeSize.y}
                             : PinholeCamera{view, width(), height()};
  }
  size_t sampleCount() const;
  bool isPlaced() const { return position.size() > 0; }
  /// The world point of a sample; nothing for an empty one. `pinhole` is reference(), which takes a while to make.
  std::optional<glm::vec3> pointOf(int x, int y, const PinholeCamera& pinhole) const {
    if (!holds(x, y)) {
      return std::nullopt;
    }
    return isPlaced() ? std::optional(position(x, y)) : pinhole.unproject(undistorted(x, y));
  }

  /// Where the reference pinhole sees the sample of pixel (x, y); t is 0 for an empty one.
  ImagePoint undistorted(int x, int y) const {
    const glm::vec2& d = displacement(x, y);
    return {static_cast<float>(x) + 0.5f - d.x, static_cast<float>(y) + 0.5f - d.y, t(x, y)};
  }
};

/// Without samples; `placed` as ReferenceImage::isPlaced().
ReferenceImage blankReferenceImage(const std::string& camera, const View& view, int width, int height,
                                   bool placed = false);

/// A union: what they show together.
using ReferenceImages = std::vector<ReferenceImage>;

/// Turns rendered fragments into a reference image: every sample keeps the displacement that unprojects it to its
/// surface.
ReferenceImage referenceImage(const FragmentImage& fragments, const Mesh& mesh, const PinholeCamera& reference,
                              const std::string& camera);

/// The same where `image` is that of the fragments `before`: only those that are others now change it.
void updateReferenceImage(ReferenceImage& image, const FragmentImage& before, const FragmentImage& fragments,
                          const Mesh& mesh, const PinholeCamera& reference);

/// The depth image: what the pinhole sees; by `renderer` where there is one.
ReferenceImage buildDepthImage(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer = nullptr);
/// The same from what the pinhole saw.
ReferenceImage depthImage(const FragmentImage& seen, const PinholeCamera& camera, const Mesh& mesh);

}  // namespace ocelli
