#include "oc_core/maze/maze_grid.h"

#include <algorithm>

namespace ocelli {

bool FloorRectangle::meets(const FloorLine& line) const {
  // The part of the line within both pairs of sides.
  double begin = 0;
  double end = 1;
  const auto clip = [&](double start, double along, double low, double high) {
    if (along == 0) {
      return start >= low && start <= high;
    }
    const double first = (low - start) / along;
    const double second = (high - start) / along;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
    return begin <= end;
  };
  return clip(line.from.x, line.to.x - line.from.x, west, east) &&
         clip(line.from.z, line.to.z - line.from.z, north, south);
}

FloorPoint MazeGrid::corner(const MazeCell& cell, int down, int right) const {
  return {origin.x + cellSize * (cell.column + right), origin.z + cellSize * (cell.row + down)};
}

FloorPoint MazeGrid::pointOf(const MazeCell& cell, double east, double south) const {
  return {origin.x + (cell.column + 0.5 + east) * cellSize, origin.z + (cell.row + 0.5 + south) * cellSize};
}

FloorRectangle MazeGrid::postAt(const FloorPoint& corner) const {
  const double half = wallThickness / 2;
  return {corner.x - half, corner.x + half, corner.z - half, corner.z + half};
}

FloorLine MazeGrid::lineOf(const MazeCell& cell, Direction side) const {
  const FloorPoint from = corner(cell, side == Direction::kSouth ? 1 : 0, side == Direction::kEast ? 1 : 0);
  return {from, isEastWest(side) ? FloorPoint{from.x, from.z + cellSize} : FloorPoint{from.x + cellSize, from.z}};
}

FloorRectangle MazeGrid::wallOf(const MazeCell& cell, Direction side) const {
  const double half = wallThickness / 2;
  const auto [from, to] = lineOf(cell, side);
  return {from.x - half, to.x + half, from.z - half, to.z + half};
}

}  // namespace ocelli
