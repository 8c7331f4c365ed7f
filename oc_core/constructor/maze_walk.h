// Where someone stands who walks along the corridors of a maze, and the crossing ahead.
#pragma once

#include <optional>

#include "oc_core/constructor/crossing_frusta.h"
#include "oc_core/scene/maze.h"

namespace ocelli {

struct MazePose {
  glm::dvec3 eye{0};
  Direction heading = Direction::kNorth;
};

struct CrossingAhead {
  MazeCell cell;
  double distance = 0;  ///< to the near face of its box
  bool left = false;
  bool ahead = false;
  bool right = false;
};

/// Throws InputError where the eye is outside of the maze, in a wall, or not between the floor and the tops of the
/// walls.
MazeCell cellOf(const Maze& maze, const glm::dvec3& eye, const std::string& where);

/// The first cell with a way to a side whose box lies ahead; nothing where there is none before the corridor ends.
std::optional<CrossingAhead> crossingAhead(const Maze& maze, const MazePose& pose);

/// How far views to the sides are deployed, 0 to 1: not in the box of a crossing; behind one, and before one that has a
/// way ahead, they grow with the distance, over so many cells. So nothing jumps where the crossing ahead becomes the
/// one behind.
double deployedAt(const Maze& maze, const MazePose& pose, double cells);

}  // namespace ocelli
