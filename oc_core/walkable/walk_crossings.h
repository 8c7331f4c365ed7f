// Where strips of floor cross or turn within an area, and the arms between.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_areas.h"

namespace ocelli {

struct WalkCrossings {
  WalkPieces pieces;
  std::vector<uint8_t> isCrossing;  ///< of each piece; the others are arms
  std::vector<uint32_t> area;       ///< of each piece, that which it mostly lies in
};

/// Floor is a crossing where the free floor of its area reaches further than 1.5 widths along both axes; crossings are
/// made rectangles where that fits. In an area with crossings, arms along x and arms along z are pieces of their own.
/// What is thin beside that is given to its neighbours, but for what joins two crossings. `radius` is that of the
/// agent, in squares.
WalkCrossings crossingsOf(const WalkField& field, const WalkAreas& areas, int radius);

}  // namespace ocelli
