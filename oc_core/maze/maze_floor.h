// The floor of a maze in metres: cells, ways between them, and what walls hide. Frame and units are those of the grid.
#pragma once

#include <optional>
#include <vector>

#include "oc_core/maze/maze_drawing.h"
#include "oc_core/maze/maze_grid.h"

namespace ocelli {

class MazeFloor {
 public:
  MazeFloor(MazeDrawing drawing, const MazeGrid& grid);

  const MazePlan& plan() const { return drawing_.plan; }
  const MazeGrid& grid() const { return grid_; }

  /// To the middle lines of its walls. Nothing outside of the maze.
  std::optional<MazeCell> cellAt(const FloorPoint& point) const;

  /// Of the shortest way from cell to cell, through the middles of cells, metres. Nothing where no way leads there. As
  /// one may cut corners, a walk can be somewhat shorter.
  std::optional<double> shortestMeters(const MazeCell& from, const MazeCell& to) const;

  /// Whether no wall or post stands in the straight line between two points. One looks out through gaps.
  bool isClear(const FloorPoint& from, const FloorPoint& to) const;

  /// The middle lines of its walls, each from post to post, line by line of the drawing.
  std::vector<FloorLine> wallLines() const;

 private:
  MazeDrawing drawing_;
  MazeGrid grid_;
  std::vector<FloorRectangle> standing_;  ///< walls and posts
};

}  // namespace ocelli
