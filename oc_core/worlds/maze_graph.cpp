#include "oc_core/worlds/maze_graph.h"

#include <algorithm>
#include <limits>

namespace ocelli {
namespace {

constexpr size_t kNoCorridor = std::numeric_limits<size_t>::max();

}  // namespace

MazeGraph::MazeGraph(const Maze& maze)
    : columns_(static_cast<size_t>(maze.columns())), corridorOfCell_(2 * maze.cellCount(), kNoCorridor) {
  const auto slot = [&](const MazeCell& cell, bool eastWest) -> size_t& {
    return corridorOfCell_[2 * maze.indexOf(cell) + (eastWest ? 0 : 1)];
  };
  size_t passages = 0;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      for (const Direction direction : {Direction::kEast, Direction::kSouth}) {
        passages += maze.isOpen(cell, direction) ? 1 : 0;
        if (maze.isOpen(cell, opposite(direction)) || !maze.isOpen(cell, direction)) {
          continue;  // no corridor starts here
        }
        Corridor corridor{{cell}, isEastWest(direction)};
        while (maze.isOpen(corridor.cells.back(), direction)) {
          corridor.cells.push_back(corridor.cells.back().neighbor(direction));
        }
        for (const MazeCell& each : corridor.cells) {
          slot(each, corridor.eastWest) = corridors.size();
        }
        corridors.push_back(std::move(corridor));
      }
    }
  }
  loops = passages + 1 - maze.cellCount();
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      const CellKind kind = maze.kind(cell);
      if (kind == CellKind::kDeadEnd) {
        deadEnds.push_back(cell);
      } else if (kind != CellKind::kStraight && kind != CellKind::kClosed) {
        crossings.push_back({cell, kind, slot(cell, true), slot(cell, false)});
      }
    }
  }
}

std::optional<size_t> MazeGraph::corridorOf(const MazeCell& cell, bool eastWest) const {
  const size_t corridor = corridorOfCell_.at(
      2 * (static_cast<size_t>(cell.row) * columns_ + static_cast<size_t>(cell.column)) + (eastWest ? 0 : 1));
  return corridor == kNoCorridor ? std::nullopt : std::optional(corridor);
}

size_t MazeGraph::count(CellKind kind) const {
  return static_cast<size_t>(
      std::count_if(crossings.begin(), crossings.end(), [&](const Crossing& c) { return c.kind == kind; }));
}

}  // namespace ocelli
