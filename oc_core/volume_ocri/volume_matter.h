// Where there is something in a volume, for cameras that take its first hits at an opacity for its surface.
//
// A place is clear where its extinction is so low that a ray through the whole volume, along the diagonal of its box,
// would not reach the opacity if all of the volume had it: with opacity a and diagonal d, where extinction * d <
// -ln(1 - a). So haze in which nothing can be hit is no matter, and there is no further number to choose.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "oc_core/render/raycast.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

class VolumeMatter {
 public:
  /// The scene must outlive it. `opacity` lies in (0, 1).
  VolumeMatter(const VolumeScene& scene, double opacity);

  /// At a point of the scene's world: outside of the volume's box, and where a clip plane hides it, all is clear.
  bool isClearAt(const glm::dvec3& point) const;

  /// What of a ray lies behind the matter that was hit at `t`: from the first clear place on. Empty where that is
  /// nothing. Places are half a mean distance of voxels apart: a gap that is narrower may be passed over.
  RayPath behind(const RayPath& ray, float t) const;

  /// Whether a voxel that is not clear, or a surface inside of the volume, lies within `reach` of a point; or the point
  /// itself is not clear.
  bool isNear(const glm::vec3& point, float reach) const;

 private:
  bool isShown(const glm::dvec3& point) const;
  bool isClearValue(double value) const;

  const VolumeScene& scene_;
  glm::dmat4 indexFromWorld_;
  double step_;           ///< of behind(), world
  double minExtinction_;  ///< by the unit of the grid, of what is not clear
  std::unique_ptr<const RayScene> surfaces_;
};

}  // namespace ocelli
