// The plan of a maze: rows x columns of cells, and the passages between them. It has no lengths and no entrance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "oc_core/maze/maze_cell.h"

namespace ocelli {

inline constexpr int kMaxMazeSide = 64;  ///< rows or columns

/// What a cell is by its passages; the entrance is none.
enum class CellKind : uint8_t { kClosed, kDeadEnd, kStraight, kTurn, kThreeWay, kFourWay };

struct MazePlan {
  /// All walls stand. Each side is 1 to kMaxMazeSide.
  MazePlan(int rows, int columns);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool contains(const MazeCell& cell) const;
  size_t cellCount() const { return static_cast<size_t>(rows_) * static_cast<size_t>(columns_); }
  /// Row by row.
  size_t indexOf(const MazeCell& cell) const {
    return static_cast<size_t>(cell.row) * static_cast<size_t>(columns_) + static_cast<size_t>(cell.column);
  }

  /// Whether there is a passage to the neighbour; false at the border, whatever the entrance.
  bool isOpen(const MazeCell& cell, Direction direction) const;
  /// The neighbour must be in the maze.
  void setOpen(const MazeCell& cell, Direction direction, bool open);

  std::vector<Direction> passages(const MazeCell& cell) const;
  CellKind kind(const MazeCell& cell) const;

  /// The cells that one walks over from `cell` in a straight line, to the first that is not straight: a turn, a
  /// crossing or a dead end. Empty where there is a wall.
  std::vector<MazeCell> ahead(const MazeCell& cell, Direction direction) const;

  /// Of the shortest way from cell to cell: passages that one goes through. Nothing where no way leads there, and where
  /// one of them is not in the maze.
  std::optional<int> shortestSteps(const MazeCell& from, const MazeCell& to) const;
  /// The same to all cells, by indexOf(). `from` must be in the maze.
  std::vector<std::optional<int>> shortestStepsFrom(const MazeCell& from) const;

  bool operator==(const MazePlan&) const = default;

 private:
  size_t wallIndex(const MazeCell& cell, Direction direction) const;

  int rows_;
  int columns_;
  std::vector<uint8_t> open_;  ///< passages: those to the east of each cell, then those to its south
};

}  // namespace ocelli
