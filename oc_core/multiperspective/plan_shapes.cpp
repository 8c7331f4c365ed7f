#include "oc_core/multiperspective/plan_shapes.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ocelli {

RayPiece clipped(const RayPiece& piece, const Box& box) {
  RayPiece kept{piece.part, {}};
  for (size_t i = 0; i + 1 < piece.points.size(); ++i) {
    const glm::vec3& a = piece.points[i];
    const glm::vec3& b = piece.points[i + 1];
    const std::optional<SegmentPart> part = partWithin(box, glm::dvec3(a), glm::dvec3(b));
    if (part && part->first < part->last) {
      if (kept.points.empty()) {
        kept.points.push_back(a + (b - a) * static_cast<float>(part->first));
      }
      kept.points.push_back(a + (b - a) * static_cast<float>(part->last));
    }
  }
  return kept;
}

std::vector<glm::vec2> convexHull(std::vector<glm::vec2> points) {
  if (points.empty()) {
    return {};
  }
  const auto cross = [](const glm::vec2& o, const glm::vec2& a, const glm::vec2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  };
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<glm::vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const size_t start = hull.size();
    for (const glm::vec2& point : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace ocelli
