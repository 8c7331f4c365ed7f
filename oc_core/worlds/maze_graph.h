// The corridors of a maze and how they meet: what recursive camera constructors walk over (dissertation, sections
// 4.3.1.4 and 4.3.2.2).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oc_core/scene/maze.h"

namespace ocelli {

/// A maximal straight run of two cells or more, from west to east or from north to south.
struct Corridor {
  std::vector<MazeCell> cells;
  bool eastWest = false;
};

/// A cell where one may or must turn: of 2 ways (a turn), 3 or 4.
struct Crossing {
  MazeCell cell;
  CellKind kind = CellKind::kTurn;
  size_t eastWest = 0;    ///< index of the corridor that runs that way
  size_t northSouth = 0;  ///< index of the other
};

struct MazeGraph {
  /// `maze` must be valid.
  explicit MazeGraph(const Maze& maze);

  std::vector<Corridor> corridors;
  std::vector<Crossing> crossings;
  std::vector<MazeCell> deadEnds;
  size_t loops = 0;  ///< independent ones: walls to put up until only one way joins any two cells

  /// Index of the corridor through the cell that runs that way; nothing where none does.
  std::optional<size_t> corridorOf(const MazeCell& cell, bool eastWest) const;
  /// Crossings of that kind.
  size_t count(CellKind kind) const;

 private:
  size_t columns_;
  std::vector<size_t> corridorOfCell_;  ///< two a cell: east-west, north-south
};

}  // namespace ocelli
