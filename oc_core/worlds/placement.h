// Where the parts of a made scene stand.
#pragma once

#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {

/// A translation to `place` after a rotation by `turnDegrees` about `axis`.
inline glm::mat4 placedAt(const glm::vec3& place, double turnDegrees = 0, const glm::vec3& axis = {0, 1, 0}) {
  return glm::rotate(glm::translate(glm::mat4(1), place), static_cast<float>(radiansFromDegrees(turnDegrees)), axis);
}

}  // namespace ocelli
