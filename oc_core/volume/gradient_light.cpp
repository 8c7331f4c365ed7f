#include "oc_core/volume/gradient_light.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "oc_core/scene/shading.h"
#include "oc_core/volume/volume_gradient.h"

namespace ocelli {

GradientLight<double> gradientLight(const glm::dmat4& worldFromIndex, const VolumeShading& shading,
                                    const ValueRange& range) {
  const double flatBelow = kFlatShare * (range.greatest - range.least);
  return {.worldFromIndexGradient = worldGradientFromIndex(worldFromIndex) *
                                    std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromIndex)))),
          .litByGradient = flatBelow > 0 ? 1 / flatBelow : 0,
          .toLight = glm::normalize(glm::dvec3(directionToLight())),
          .ambient = shading.ambient,
          .diffuse = shading.diffuse,
          .specular = shading.specular,
          .shininess = shading.shininess};
}

GradientLight<float> singleLight(const GradientLight<double>& light, double factor) {
  return {.worldFromIndexGradient = glm::mat3(light.worldFromIndexGradient * factor),
          .litByGradient = static_cast<float>(light.litByGradient),
          .toLight = glm::vec3(light.toLight),
          .ambient = static_cast<float>(light.ambient),
          .diffuse = static_cast<float>(light.diffuse),
          .specular = static_cast<float>(light.specular),
          .shininess = static_cast<float>(light.shininess)};
}

}  // namespace ocelli
