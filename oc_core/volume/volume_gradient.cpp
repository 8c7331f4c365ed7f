#include "oc_core/volume/volume_gradient.h"

#include <algorithm>
#include <glm/matrix.hpp>

namespace ocelli {

glm::dmat3 worldGradientFromIndex(const glm::dmat4& worldFromIndex) {
  return glm::transpose(glm::inverse(glm::dmat3(worldFromIndex)));
}

glm::dvec3 gradientAt(const ScalarVolume& volume, const glm::dvec3& index) {
  glm::dvec3 byIndex(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double last = volume.grid().size[axis] - 1;
    glm::dvec3 before = index;
    glm::dvec3 after = index;
    before[axis] = std::clamp(index[axis] - 1, 0.0, last);
    after[axis] = std::clamp(index[axis] + 1, 0.0, last);
    const double distance = after[axis] - before[axis];
    if (distance > 0) {
      byIndex[axis] = (volume.fieldAt(after) - volume.fieldAt(before)) / distance;
    }
  }
  return worldGradientFromIndex(volume.grid().worldFromIndex) * byIndex;
}

}  // namespace ocelli
