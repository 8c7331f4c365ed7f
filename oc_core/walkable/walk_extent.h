// How far pieces of floor reach along the axes of the grid.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_pieces.h"

namespace ocelli {

/// A row of squares; `last` belongs to it.
struct SquareRange {
  int first = 0;
  int last = -1;

  int length() const { return last - first + 1; }
};

/// x or z of a square.
inline int coordinateOf(const WalkField& field, uint32_t square, bool alongX) {
  return alongX ? field.squares[square].x : field.squares[square].z;
}

/// The side of the largest free square in squares, from halfWidths() (walk_width.h).
inline double widthOf(uint16_t half) {
  return 2.0 * half - 1;
}

/// Where the squares are at least half as many as in the median row across. There must be one.
SquareRange extentOf(const WalkField& field, const std::vector<uint32_t>& squares, bool alongX);

/// The squares of each piece.
std::vector<std::vector<uint32_t>> squaresOf(const WalkPieces& pieces);

}  // namespace ocelli
