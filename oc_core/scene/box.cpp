#include "oc_core/scene/box.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {

void Box::add(const glm::vec3& point) {
  lower = glm::min(lower, point);
  upper = glm::max(upper, point);
}

std::array<glm::vec3, 8> cornersOf(const Box& box) {
  std::array<glm::vec3, 8> corners;
  for (size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
                  (i & 4) != 0 ? box.upper.z : box.lower.z};
  }
  return corners;
}

bool contains(const Box& box, const glm::vec3& point) {
  return glm::clamp(point, box.lower, box.upper) == point;
}

std::optional<SegmentPart> partWithin(const Box& box, const glm::dvec3& from, const glm::dvec3& to) {
  if (box.empty()) {
    return std::nullopt;
  }
  SegmentPart part;
  for (int i = 0; i < 3; ++i) {
    const double way = to[i] - from[i];
    const double lower = static_cast<double>(box.lower[i]) - from[i];
    const double upper = static_cast<double>(box.upper[i]) - from[i];
    if (way == 0) {
      if (lower > 0 || upper < 0) {
        return std::nullopt;
      }
      continue;
    }
    part.first = std::max(part.first, std::min(lower / way, upper / way));
    part.last = std::min(part.last, std::max(lower / way, upper / way));
  }
  return part.first <= part.last ? std::optional(part) : std::nullopt;
}

bool meets(const Box& box, const glm::vec3& from, const glm::vec3& to) {
  return partWithin(box, glm::dvec3(from), glm::dvec3(to)).has_value();
}

}  // namespace ocelli
