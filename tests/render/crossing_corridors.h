// A scene and a graph camera that sees around its corners.
#pragma once

#include "tests/camera/test_graph_cameras.h"

namespace ocelli::test {

/// A corridor along z that ends in one along x: 2 wide and high, with a ball or a box in each of its three arms.
inline Mesh crossingCorridors() {
  Mesh mesh;
  const auto wall = [&](float x0, float z0, float x1, float z1) {
    addQuad(mesh, {x0, 0, z0}, {x1, 0, z1}, {x1, 2, z1}, {x0, 2, z0});
  };
  for (const float side : {-1.0f, 1.0f}) {
    wall(side, 0, side, 10);
    wall(side, 0, 8 * side, 0);
    wall(8 * side, 0, 8 * side, -2);
  }
  wall(-8, -2, 8, -2);
  wall(-1, 10, 1, 10);
  for (const float y : {0.0f, 2.0f}) {
    addQuad(mesh, {-1, y, 10}, {1, y, 10}, {1, y, 0}, {-1, y, 0});
    addQuad(mesh, {-8, y, 0}, {8, y, 0}, {8, y, -2}, {-8, y, -2});
  }
  const auto at = [](const glm::vec3& place) { return glm::translate(glm::mat4(1), place); };
  append(mesh, makeSphere(32), at({-3, 0.6f, -1.2f}) * glm::scale(glm::mat4(1), glm::vec3(0.3f)));
  append(mesh, makeSphere(32), at({0.4f, 1, 4}) * glm::scale(glm::mat4(1), glm::vec3(0.25f)));
  append(mesh, makeBox(glm::vec3(0.3f)), at({3, 0.8f, -0.8f}));
  return mesh;
}

/// From the end of the first corridor, around both corners at its other end.
inline GraphCamera aroundCorners(int width = 480) {
  View view;
  view.eye = {0, 1, 9.5f};
  view.target = {0, 1, 0};
  view.fovVerticalDegrees = 50;
  view.zNear = 0.05f;
  view.zFar = 60;
  GraphCamera graph(PinholeCamera(view, width, width * 2 / 3));
  graph.split(0, turnAt({0, 0, -2}, {-2, 0, -1}, {8, 1, -1}), turnAt({0, 0, -2}, {2, 0, -1}, {-8, 1, -1}), "left",
              "right");
  return graph;
}

}  // namespace ocelli::test
