#include "oc_core/maze/maze_floor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ocelli {

MazeFloor::MazeFloor(MazeDrawing drawing, const MazeGrid& grid) : drawing_(std::move(drawing)), grid_(grid) {
  for (const MazeWall& wall : drawing_.walls()) {
    standing_.push_back(grid_.wallOf(wall.cell, wall.side));
  }
  for (int row = 0; row <= plan().rows(); ++row) {
    for (int column = 0; column <= plan().columns(); ++column) {
      standing_.push_back(grid_.postAt(grid_.corner({row, column})));
    }
  }
}

std::optional<MazeCell> MazeFloor::cellAt(const FloorPoint& point) const {
  const double column = std::floor((point.x - grid_.origin.x) / grid_.cellSize);
  const double row = std::floor((point.z - grid_.origin.z) / grid_.cellSize);
  // Written so that NaN is outside.
  const bool inside = column >= 0 && column < plan().columns() && row >= 0 && row < plan().rows();
  return inside ? std::optional(MazeCell{static_cast<int>(row), static_cast<int>(column)}) : std::nullopt;
}

std::optional<double> MazeFloor::shortestMeters(const MazeCell& from, const MazeCell& to) const {
  const std::optional<int> steps = plan().shortestSteps(from, to);
  return steps ? std::optional(*steps * grid_.cellSize) : std::nullopt;
}

bool MazeFloor::isClear(const FloorPoint& from, const FloorPoint& to) const {
  return std::none_of(standing_.begin(), standing_.end(), [&](const FloorRectangle& rectangle) {
    return rectangle.meets({from, to});
  });
}

std::vector<FloorLine> MazeFloor::wallLines() const {
  std::vector<FloorLine> lines;
  for (const MazeWall& wall : drawing_.walls()) {
    lines.push_back(grid_.lineOf(wall.cell, wall.side));
  }
  return lines;
}

}  // namespace ocelli
