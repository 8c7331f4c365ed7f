// Walls and posts of a maze as rectangles on its floor.
//
// Metres: x to the east, z to the south. Walls stand on the lines between cells, half of their thickness on either
// side, and a post of the same thickness stands at every corner of the grid. A wall reaches from post to post and over
// both.
#pragma once

#include "oc_core/maze/maze_cell.h"

namespace ocelli {

/// Or a direction between two points.
struct FloorPoint {
  double x = 0;
  double z = 0;

  bool operator==(const FloorPoint&) const = default;
};

struct FloorLine {
  FloorPoint from;
  FloorPoint to;
};

/// The sides belong to it.
struct FloorRectangle {
  double west = 0;
  double east = 0;
  double north = 0;
  double south = 0;

  /// Whether any point of the line lies in it, the ends included.
  bool meets(const FloorLine& line) const;
};

/// How large the cells of a maze are, and where they lie.
struct MazeGrid {
  double cellSize = 3;  ///< from the middle of a wall to that of the next
  double wallThickness = 0.3;
  FloorPoint origin{};  ///< the corner of the north-west, on the middle lines of the outer walls

  /// The corner of a cell, to the south and the east by whole cells.
  FloorPoint corner(const MazeCell& cell, int down = 0, int right = 0) const;
  /// The middle of a cell, moved by parts of a cell.
  FloorPoint pointOf(const MazeCell& cell, double east = 0, double south = 0) const;

  /// Of the post that stands at a corner of the grid.
  FloorRectangle postAt(const FloorPoint& corner) const;
  /// The middle line of the wall on that side of the cell, from post to post: to the east or to the south.
  FloorLine lineOf(const MazeCell& cell, Direction side) const;
  FloorRectangle wallOf(const MazeCell& cell, Direction side) const;
};

}  // namespace ocelli
