// Which frustum of a graph camera holds a point of the world that the small camera sees: slow and obvious.
#pragma once

#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli::test {

inline const glm::dvec3 kLower(-4, -4, -14);
inline const glm::dvec3 kUpper(4, 4, 10);

inline glm::dvec3 randomPoint(Numbers& numbers) {
  return {numbers.between(kLower.x, kUpper.x), numbers.between(kLower.y, kUpper.y),
          numbers.between(kLower.z, kUpper.z)};
}

/// Whether a frustum holds a point, turn by turn up to the root.
inline bool holds(const GraphCamera& graph, int i, const glm::dvec3& point) {
  const auto frustum = [&](int k) -> const GraphCamera::Frustum& { return graph.frusta()[static_cast<size_t>(k)]; };
  glm::dvec3 at = point;
  for (int k = i;; k = frustum(k).parent) {
    if (frustum(k).plane.height(at) < 0) {
      return false;
    }
    if (k == GraphCamera::kRoot) {
      break;
    }
    at = frustum(k).plane.crossing(frustum(k).viewpoint, at);
  }
  const glm::dvec4 h = frustum(0).pixelFromWorld * glm::dvec4(at, 1);
  const glm::dvec2 pixel(h.x / h.w, h.y / h.w);
  const GraphCamera::Part& part = frustum(i).part;
  for (size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2 along = part[(k + 1) % part.size()] - part[k];
    const glm::dvec2 to = pixel - part[k];
    if (along.x * to.y - along.y * to.x < 0) {
      return false;
    }
  }
  const int child = graph.childAt(i, pixel);
  return child < 0 ? !graph.isBeyondLimits(i, point) : frustum(child).plane.height(point) <= 0;
}

}  // namespace ocelli::test
