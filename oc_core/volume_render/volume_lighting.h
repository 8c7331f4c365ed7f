// How places of volumes are lit (VolumeShading): by the direction of the field's gradient, in double precision. This is
// what every faster way must give.
//
// The gradient at a point is that of central differences over a voxel to either side, by the trilinear field, of the
// nearest point among the voxels' centres: in index coordinates,
//
//   g_i = (f(p + e_i) - f(p - e_i)) / 2,
//
// taken to the world by the inverse transpose. With n its direction, l that to the light, and h that of l + v, where v
// is the direction back along the ray, the colour c of the place becomes
//
//   c (ambient + diffuse |n.l|) + specular |n.h|^shininess,
//
// on both sides alike, as which side of a layer is its outside depends on the values around it. Where the field is
// flat it has no direction: where its gradient, by the mean distance of voxels, is below kFlatShare of the volume's
// range, that of the formula turns linearly into c.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// What is done to the colour of a place: it is multiplied by `factor`, and `added` is added to each of its channels.
struct PlaceLight {
  double factor = 1;
  double added = 0;
};

class VolumeLighting {
 public:
  /// The scene must outlive it. `range` is that of the values of the volume.
  VolumeLighting(const VolumeScene& scene, const ValueRange& range);

  /// `index` lies in the box of the volume.
  glm::dvec3 indexGradientAt(const glm::dvec3& index) const;
  /// `direction` is that of the ray in the scene's world, of length 1.
  PlaceLight at(const glm::dvec3& index, const glm::dvec3& direction) const;

  /// Takes a gradient of values by index coordinates to one of the scene's world, by the mean distance of voxels.
  const glm::dmat3& worldFromIndexGradient() const { return worldFromIndexGradient_; }
  /// Gradients of the length at which a place counts as having a direction, as the matrix gives them; 0 of a volume
  /// whose values are all the same.
  double flatBelow() const { return flatBelow_; }
  /// In the scene's world, of length 1: where the light of meshes is (scene/shading.h).
  const glm::dvec3& toLight() const { return toLight_; }

 private:
  const VolumeScene& scene_;
  glm::dmat3 worldFromIndexGradient_;
  double flatBelow_;
  glm::dvec3 toLight_;
};

}  // namespace ocelli
