// Directions around a normal, and numbers that are a pixel's own. For .cpp files.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "oc_core/base/random.h"

namespace ocelli {

/// Two unit vectors across a unit vector, and that.
struct SurfaceFrame {
  explicit SurfaceFrame(const glm::vec3& unit) : normal(unit) {
    const glm::vec3 other = std::abs(unit.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    across = glm::normalize(glm::cross(other, unit));
    along = glm::cross(unit, across);
  }
  glm::vec3 worldOf(const glm::vec3& local) const { return across * local.x + along * local.y + normal * local.z; }

  glm::vec3 normal;
  glm::vec3 across{0};
  glm::vec3 along{0};
};

/// From 0 to 1, the same for the same pixel and seed.
inline float unitHash(uint32_t pixel, uint64_t seed) {
  return Random((seed << 32) ^ pixel).inRange(0, 1);
}

}  // namespace ocelli
