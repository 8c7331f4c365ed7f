#include "display_sim/viewer/camera_rays.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {

std::vector<glm::vec3> rayBetween(const RayPath& ray, const PinholeCamera& reference, float nearest, float farthest) {
  std::vector<glm::vec3> part;
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    glm::vec3 from = ray[i];
    glm::vec3 to = ray[i + 1];
    float zFrom = reference.cameraFromWorld(from).z;
    float zTo = reference.cameraFromWorld(to).z;
    if (zFrom > zTo) {  // a ray may run backwards for a piece
      continue;
    }
    if (zTo < nearest || zFrom > farthest) {
      continue;
    }
    const glm::vec3 along = zTo > zFrom ? (to - from) / (zTo - zFrom) : glm::vec3(0);
    if (zTo > farthest) {
      to = from + along * (farthest - zFrom);
    }
    if (zFrom < nearest) {
      from += along * (nearest - zFrom);
    }
    if (part.empty()) {
      part.push_back(from);
    }
    part.push_back(to);
  }
  return part;
}

bool isBent(const std::vector<glm::vec3>& ray, float tolerance) {
  if (ray.size() < 3 || ray.front() == ray.back()) {
    return false;
  }
  const glm::vec3 direction = glm::normalize(ray.back() - ray.front());
  return std::ranges::any_of(
      ray, [&](const glm::vec3& point) { return glm::length(glm::cross(point - ray.front(), direction)) > tolerance; });
}

}  // namespace ocelli
