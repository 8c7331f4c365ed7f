// Graph cameras for tests: of the small camera's view from (0, 0, 10) towards the origin.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

inline GraphCamera::Bend turnAt(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& viewpoint) {
  return {Plane::through(point, normal), viewpoint};
}

/// Splits before the origin, to both sides of a vertical line in the middle, then bends the left one again.
inline GraphCamera crossroads(const PinholeCamera& camera = smallCamera()) {
  GraphCamera graph(camera);
  const auto [left, right] = graph.split(0, turnAt({0, 0, 0.5}, {-0.3, 0, -1}, {1.5, 0, 7}),
                                         turnAt({0, 0, 0.5}, {0.3, 0, -1}, {-1.5, 0, 7}), "left", "right");
  graph.bend(left, turnAt({-0.5, 0, -1.5}, {-0.8, 0.1, -1}, {0.5, -0.3, 4}), "far left");
  static_cast<void>(right);
  return graph;
}

}  // namespace ocelli::test
