// Random directions and places, for scenes of many small things.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "oc_core/base/random.h"

namespace ocelli {

/// Evenly in the ball of radius 1, without its centre.
inline glm::vec3 randomInBall(Random& random) {
  while (true) {
    const float x = random.inRange(-1, 1);
    const float y = random.inRange(-1, 1);
    const float z = random.inRange(-1, 1);
    const float length2 = x * x + y * y + z * z;
    if (length2 <= 1 && length2 > 1e-6f) {
      return {x, y, z};
    }
  }
}

inline glm::vec3 randomDirection(Random& random) {
  return glm::normalize(randomInBall(random));
}

/// A unit vector at right angles to `direction`, a unit vector, too.
inline glm::vec3 randomBeside(const glm::vec3& direction, Random& random) {
  while (true) {
    const glm::vec3 beside = glm::cross(direction, randomDirection(random));
    const float length = glm::length(beside);
    if (length > 0.05f) {
      return beside / length;
    }
  }
}

}  // namespace ocelli
