// Floor divided into areas of one width each: rooms, and streets or corridors with what crosses them.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_pieces.h"

namespace ocelli {

/// Of the widest place of an area: what is narrower is another one, or an opening.
inline constexpr double kSameWidth = 0.8;

struct WalkAreas {
  WalkPieces pieces;
  std::vector<uint16_t> halfWidth;  ///< of each, as halfWidths()
};

/// From the widest place down, floor joins an area that it touches where it is four fifths as wide as that at least,
/// and begins one otherwise. Areas that are much thinner than the space they stand in, such as the floor of a door
/// within its wall, and niches of facades, are given to a neighbour. So are
/// areas of less than `smallest` squares, such as the floor below an arch. `radius` is that of the agent, in squares.
WalkAreas areasOf(const WalkField& field, const std::vector<uint16_t>& halfWidths, int radius, size_t smallest);

}  // namespace ocelli
