// Whether coordinates are numbers at all.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace ocelli {

inline bool isFinite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace ocelli
