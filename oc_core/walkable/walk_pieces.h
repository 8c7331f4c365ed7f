// A floor divided into pieces: each square has the number of its piece, and what is done with such numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// Numbers from 0 on, without gaps.
struct WalkPieces {
  std::vector<uint32_t> of;  ///< by square
  uint32_t count = 0;

  std::vector<size_t> sizes() const;
};

/// How many squares of each piece one can stand on: those that are not under obstacles.
std::vector<size_t> standingSizes(const WalkField& field, const WalkPieces& pieces);

/// Two pieces that touch: over how many sides of squares.
struct PieceBorder {
  uint32_t a = 0;  ///< the lower number
  uint32_t b = 0;
  size_t length = 0;
};

/// In order of a, then b.
std::vector<PieceBorder> bordersOf(const WalkField& field, const std::vector<uint32_t>& labels);

/// The connected parts of squares of equal labels, numbered by their first squares. kNoSquare is no label.
WalkPieces connectedPieces(const WalkField& field, const std::vector<uint32_t>& labels);

/// Gives each piece that is marked to the neighbour with the longest border that is not marked, the smallest first,
/// as long as there are such. Marked pieces that touch none stay.
WalkPieces absorbed(const WalkField& field, const WalkPieces& pieces, const std::vector<uint8_t>& isMarked);

/// The largest stepsToBorder() in each piece.
std::vector<uint16_t> thicknesses(const WalkField& field, const WalkPieces& pieces);

}  // namespace ocelli
