// Mazes from a seed, the same on every platform.
#pragma once

#include <cstdint>

#include "oc_core/scene/maze.h"

namespace ocelli {

struct MazeOptions {
  uint64_t seed = 1;
  int rows = 7;
  int columns = 7;
  double loops = 0.15;     ///< share of the walls within the maze that is opened again, once every cell can be reached
  size_t minThreeWay = 0;  ///< crossings of 3 ways
  size_t minFourWay = 0;   ///< crossings of 4 ways
  size_t landmarks = 10;   ///< no two in one cell; in as many corridors as there are
};

/// A valid maze: crossings as asked for, a spanning tree of long corridors that joins them (depth first search), and
/// walls opened at random. More loops come where crossings are too few after that. The last wall at a post is never
/// opened, so walls stay between corridors. The entrance is in the south. Throws InputError where a maze of this size
/// cannot be, or was not, given so many crossings or landmarks.
Maze generateMaze(const MazeOptions& options);

}  // namespace ocelli
