#include "study/task/instruction_image.h"

#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli {

PinholeCamera exampleEye(const Maze& maze, const MazeCell& cell, Direction heading, double backMeters,
                         const glm::ivec2& size) {
  constexpr float kExampleEyeMeters = 1.2f;
  constexpr double kExampleFovDegrees = 60;
  View view;
  view.eye =
      maze.centerOf(cell) + glm::vec3(0, kExampleEyeMeters, 0) - static_cast<float>(backMeters) * vectorOf(heading);
  view.target = view.eye + vectorOf(heading);
  view.fovVerticalDegrees =
      degreesFromRadians(2 * std::atan(std::tan(radiansFromDegrees(kExampleFovDegrees / 2)) * size.y / size.x));
  view.zNear = 0.05f;
  view.zFar = 200;
  return {view, size.x, size.y};
}

PixelRect wholeImage(const glm::ivec2& size) {
  return {0, 0, static_cast<double>(size.x), static_cast<double>(size.y)};
}

}  // namespace ocelli
