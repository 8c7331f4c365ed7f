#include "oc_core/volume_render/volume_lighting.h"

#include <glm/common.hpp>

namespace ocelli {

VolumeLighting::VolumeLighting(const VolumeScene& scene, const ValueRange& range)
    : scene_(scene), light_(gradientLight(scene.worldFromIndex, scene.appearance.shading, range)) {}

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

PlaceLight<double> VolumeLighting::at(const glm::dvec3& index, const glm::dvec3& direction) const {
  return light_.at(indexGradientAt(index), direction);
}

}  // namespace ocelli
