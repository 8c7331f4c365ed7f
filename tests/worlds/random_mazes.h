// Mazes of many shapes for tests.
#pragma once

#include "oc_core/worlds/maze_generator.h"

namespace ocelli::test {

/// From 1 x 2 to 9 x 10 cells, without loops and with as many as there can be.
inline MazeOptions mazeOptions(uint64_t seed) {
  MazeOptions options;
  options.seed = seed;
  options.rows = 1 + static_cast<int>(seed % 9);
  options.columns = 2 + static_cast<int>(seed / 9 % 9);
  options.loops = static_cast<double>(seed % 5) / 4;
  options.landmarks = seed % static_cast<uint64_t>(options.rows * options.columns);
  return options;
}

}  // namespace ocelli::test
