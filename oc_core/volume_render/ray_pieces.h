// What of a ray lies within a volume: pieces of its polyline, in index coordinates. For .cpp files.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "oc_core/camera/ray_hull.h"
#include "oc_core/camera/ray_path.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/volume_render/index_points.h"

namespace ocelli {

/// A straight piece of a ray.
// Without initial values: there is room for as many as a ray may have points, for every ray.
struct VolumeRayPiece {
  glm::dvec3 from;       ///< index coordinates
  glm::dvec3 way;        ///< the same, by length
  glm::dvec3 direction;  ///< in the scene's world, of length 1
  double length;         ///< in the unit of the grid's world: that of extinctions
  double t;              ///< the ray's parameter where the piece begins
  double tByLength;
  bool continues;  ///< it begins where the piece before ends
};

/// The box of a volume and its clips, which together are convex.
class VolumeExtent {
 public:
  using Pieces = std::array<VolumeRayPiece, RayPath::kMaxPoints>;

  /// The scene must outlive it, and its volume and clips must not change.
  explicit VolumeExtent(const VolumeScene& scene);

  /// Nothing is seen beyond that box: rays that miss it have no pieces. To begin with it is the volume's.
  void setSeen(const IndexBox& box);

  /// The pieces of a ray before the parameter `end`, from near to far: how many of `pieces` were written. None for a
  /// ray with coordinates that are not finite.
  size_t cut(const RayPath& ray, double end, Pieces& pieces) const;

  /// Whether each of these pieces, in the world, lies beyond a face of what is seen, so that no ray in them meets it.
  /// False where a point is not finite.
  bool misses(const HullPieces& hull) const;

 private:
  const VolumeScene& scene_;
  glm::dmat4 indexFromWorld_;
  double worldLengthOfUnit_;
  double unitsByWorldLength_;
  IndexBox box_;
  IndexBox seen_;
};

}  // namespace ocelli
