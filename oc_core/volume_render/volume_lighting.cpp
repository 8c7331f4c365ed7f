#include "oc_core/volume_render/volume_lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "oc_core/scene/shading.h"

namespace ocelli {

VolumeLighting::VolumeLighting(const VolumeScene& scene, const ValueRange& range)
    : scene_(scene),
      worldFromIndexGradient_(glm::transpose(glm::inverse(glm::dmat3(scene.worldFromIndex))) *
                              std::cbrt(std::abs(glm::determinant(glm::dmat3(scene.worldFromIndex))))),
      flatBelow_(kFlatShare * (range.greatest - range.least)),
      toLight_(glm::normalize(glm::dvec3(directionToLight()))) {}

glm::dvec3 VolumeLighting::indexGradientAt(const glm::dvec3& index) const {
  const ScalarVolume& volume = *scene_.volume;
  const glm::dvec3 last(volume.grid().size - 1);
  const glm::dvec3 center = glm::clamp(index, glm::dvec3(0), last);
  glm::dvec3 gradient(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 one(0);
    one[axis] = 1;
    gradient[axis] =
        (volume.fieldAt(glm::min(center + one, last)) - volume.fieldAt(glm::max(center - one, glm::dvec3(0)))) / 2;
  }
  return gradient;
}

PlaceLight VolumeLighting::at(const glm::dvec3& index, const glm::dvec3& direction) const {
  const VolumeShading& shading = scene_.appearance.shading;
  const glm::dvec3 gradient = worldFromIndexGradient_ * indexGradientAt(index);
  const double length = glm::length(gradient);
  if (!(length > 0)) {
    return {};
  }
  const double lit = std::min(length / flatBelow_, 1.0);
  const glm::dvec3 normal = gradient / length;
  const glm::dvec3 between = toLight_ - direction;
  const double betweenLength = glm::length(between);
  const double highlight = betweenLength > 0 ? std::abs(glm::dot(normal, between)) / betweenLength : 0;
  const double diffuse = shading.ambient + shading.diffuse * std::abs(glm::dot(normal, toLight_));
  return {std::lerp(1.0, diffuse, lit), lit * shading.specular * std::pow(highlight, shading.shininess)};
}

}  // namespace ocelli
