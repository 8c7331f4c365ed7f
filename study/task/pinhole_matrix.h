// Planar pinhole cameras in a grid that show a maze together (section 7.3.2, Figure 7.2): laid by hand.
#pragma once

#include <vector>

#include "study/task/task.h"

namespace ocelli {

class JsonFields;

struct MatrixView {
  MazeCell cell;
  double east = 0;  ///< of the eye from the middle of the cell, in cell sizes
  double south = 0;
  double heightMeters = 1.6;
  double headingDegrees = 0;  ///< clockwise; 0 is north
  double pitchDegrees = 0;    ///< up
  double fovHorizontalDegrees = 70;
};

struct PinholeMatrix {
  int rows = 1;
  int columns = 1;
  std::vector<MatrixView> views{};  ///< row by row; no more than there are places
};

/// Of an object with the fields "rows", "columns" and "views". Throws InputError naming the field, as where an eye
/// stands in a wall.
PinholeMatrix readPinholeMatrix(JsonFields& fields, const Maze& maze);

/// Laid out in `area`.
std::vector<Vantage::Pane> panesOf(const PinholeMatrix& matrix, const Maze& maze, const PixelRect& area);

}  // namespace ocelli
