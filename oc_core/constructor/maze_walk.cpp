#include "oc_core/constructor/maze_walk.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// How far ahead of the near face of a cell's box the eye is.
double beyondNearFace(const Maze& maze, const MazePose& pose, const MazeCell& cell) {
  const CrossingFrame frame(maze, cell, pose.heading);
  return glm::dot(pose.eye - frame.corner, frame.ahead);
}

bool hasSideWay(const Maze& maze, const MazeCell& cell, Direction heading) {
  return maze.isOpen(cell, leftOf(heading)) || maze.isOpen(cell, rightOf(heading));
}

MazeCell cellBelow(const Maze& maze, const MazePose& pose) {
  return cellOf(maze, pose.eye, "position in a maze");
}

}  // namespace

MazeCell cellOf(const Maze& maze, const glm::dvec3& eye, const std::string& where) {
  const glm::vec3 point(eye);
  const std::string at = fmt::format("the position ({}, {}, {})", point.x, point.y, point.z);
  const std::optional<MazeCell> cell = maze.cellAt(point);
  if (!cell) {
    throw InputError(at + " is outside of the maze", where, "give one in a corridor");
  }
  if (maze.isInWall(point)) {
    throw InputError(at + " is inside a wall, near the cell " + nameOf(*cell), where, "give one in a corridor");
  }
  if (!(point.y > maze.origin.y && point.y < maze.origin.y + maze.wallHeight)) {
    throw InputError(at + " is below the floor or above the walls", where,
                     fmt::format("give a height between {} and {}", maze.origin.y, maze.origin.y + maze.wallHeight));
  }
  return *cell;
}

std::optional<CrossingAhead> crossingAhead(const Maze& maze, const MazePose& pose) {
  MazeCell cell = cellBelow(maze, pose);
  while (!hasSideWay(maze, cell, pose.heading) || beyondNearFace(maze, pose, cell) > 0) {
    if (!maze.isOpen(cell, pose.heading)) {
      return std::nullopt;
    }
    cell = cell.neighbor(pose.heading);
  }
  return CrossingAhead{cell, -beyondNearFace(maze, pose, cell), maze.isOpen(cell, leftOf(pose.heading)),
                       maze.isOpen(cell, pose.heading), maze.isOpen(cell, rightOf(pose.heading))};
}

double deployedAt(const Maze& maze, const MazePose& pose, double cells) {
  const double reach = static_cast<double>(maze.cellSize) * cells;
  const double width = static_cast<double>(maze.cellSize) - static_cast<double>(maze.wallThickness);
  double deployed = 1;
  // The last crossing that was entered.
  for (MazeCell cell = cellBelow(maze, pose);; cell = cell.neighbor(opposite(pose.heading))) {
    const double beyond = beyondNearFace(maze, pose, cell);
    if (hasSideWay(maze, cell, pose.heading) && beyond > 0) {
      deployed = std::clamp((beyond - width) / reach, 0.0, 1.0);
      break;
    }
    if (!maze.isOpen(cell, opposite(pose.heading))) {
      break;
    }
  }
  const std::optional<CrossingAhead> next = crossingAhead(maze, pose);
  return next && next->ahead ? deployed * std::clamp(next->distance / reach, 0.0, 1.0) : deployed;
}

}  // namespace ocelli
