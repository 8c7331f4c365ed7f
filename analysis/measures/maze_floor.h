// The floor of a maze as an analysis needs it: cells, ways between them, and what walls hide.
//
// Metres as in the pose log: x to the east, z to the south, from the north-western corner, on the middle lines of the
// outer walls. Walls stand on the lines between cells, half of their thickness on either side; a post stands at each
// corner.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/dataset/protocol_facts.h"

namespace ocelli {

struct FloorPoint {
  double x = 0;
  double z = 0;
};

struct FloorCell {
  int row = 0;
  int column = 0;

  bool operator==(const FloorCell&) const = default;
};

class MazeFloor {
 public:
  /// Throws InputError where the drawing is not a valid maze.
  explicit MazeFloor(const ProtocolMaze& maze);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  double cellSize() const { return cellSize_; }
  /// Row by row.
  size_t indexOf(const FloorCell& cell) const { return static_cast<size_t>(cell.row * columns_ + cell.column); }
  bool contains(const FloorCell& cell) const;
  /// Nothing outside of the maze.
  std::optional<FloorCell> cellAt(const FloorPoint& point) const;
  /// Of its middle, moved by parts of a cell.
  FloorPoint pointOf(const FloorCell& cell, double east = 0, double south = 0) const;

  /// Of the shortest way from cell to cell, through the middles of cells, metres. Nothing where no way leads there. As
  /// one may cut corners, a walk can be somewhat shorter.
  std::optional<double> shortestMeters(const FloorCell& from, const FloorCell& to) const;

  /// Whether no wall or post stands in the straight line between two points.
  bool isClear(const FloorPoint& from, const FloorPoint& to) const;

 private:
  struct Rectangle {
    double west = 0;
    double east = 0;
    double north = 0;
    double south = 0;
  };
  bool isOpenToEast(const FloorCell& cell) const;
  bool isOpenToSouth(const FloorCell& cell) const;
  static bool meets(const Rectangle& rectangle, const FloorPoint& from, const FloorPoint& to);

  std::vector<std::string> plan_;
  int rows_ = 0;
  int columns_ = 0;
  double cellSize_;
  std::vector<Rectangle> walls_;
};

/// The middle lines of its walls, each from post to post: x, z to x, z.
std::vector<std::array<double, 4>> wallLines(const ProtocolMaze& maze);

}  // namespace ocelli
