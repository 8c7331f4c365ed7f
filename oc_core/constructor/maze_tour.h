// The order in which a camera that shows a whole maze walks through it (section 4.3.2.2): legs from one crossing to the
// next, so that every cell is in one leg only.
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/scene/maze.h"

namespace ocelli {

enum class TourOrder {
  kBreadthFirst,  ///< short ways from the start
  kDepthFirst,    ///< each way to its end before the next
};

/// A straight walk over cells that no other leg has. It ends at a dead end, where all ways on belong to other legs, or
/// where the tour turns or branches.
struct TourLeg {
  int parent = -1;
  Direction heading = Direction::kNorth;
  std::vector<MazeCell> cells;  ///< from the first that the parent does not have to the end
  std::vector<int> children;    ///< those to the left, ahead and to the right, as far as there are
  size_t cellsAfter = 0;        ///< in all legs that follow
};

/// Parents come before their children; the first leg begins with the cell `start`. Throws InputError where `start` is
/// not in the maze.
std::vector<TourLeg> tourOf(const Maze& maze, const MazeCell& start, Direction heading, TourOrder order);

}  // namespace ocelli
