// How places of volumes are lit (oc_core/volume/gradient_light.h), in double precision. This is what every faster way
// must give.
//
// The gradient at a point is that of central differences over a voxel to either side, by the trilinear field, of the
// nearest point among the voxels' centres: in index coordinates,
//
//   g_i = (f(p + e_i) - f(p - e_i)) / 2,
//
// taken to the world by the inverse transpose.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/volume/gradient_light.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

class VolumeLighting {
 public:
  /// The scene must outlive it. `range` is that of the values of the volume.
  VolumeLighting(const VolumeScene& scene, const ValueRange& range);

  /// `index` lies in the box of the volume.
  glm::dvec3 indexGradientAt(const glm::dvec3& index) const;
  /// `direction` is that of the ray in the scene's world, of length 1.
  PlaceLight<double> at(const glm::dvec3& index, const glm::dvec3& direction) const;

 private:
  const VolumeScene& scene_;
  GradientLight<double> light_;
};

}  // namespace ocelli
