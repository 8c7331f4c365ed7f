// The segments of ray paths as intersection sees them. For .cpp files.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/camera/ray_path.h"

namespace ocelli {

/// Embree stops the program where a ray is not finite, or as long as 1.8e18.
inline bool castable(const glm::vec3& origin, const glm::vec3& step) {
  constexpr float kMax = 1e18f;
  const auto within = [](const glm::vec3& p) {
    return std::abs(p.x) < kMax && std::abs(p.y) < kMax && std::abs(p.z) < kMax;
  };
  return within(origin) && within(step);
}

/// How far a segment reaches, 1 being its end. A surface just where two segments meet must not fall between them: all
/// but the last go on for as much as coordinates are rounded by.
inline float reachOf(const RayPath& path, size_t segment) {
  if (segment + 1 == path.size()) {
    return 1;
  }
  constexpr float kRounding = 1e-6f;
  const glm::vec3 largest = glm::max(glm::abs(path[segment - 1]), glm::abs(path[segment]));
  const float length = glm::distance(path[segment - 1], path[segment]);
  return 1 + kRounding * std::max({largest.x, largest.y, largest.z}) / std::max(length, kRounding);
}

}  // namespace ocelli
