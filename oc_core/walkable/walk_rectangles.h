// Pieces of floor that are no rectangles, divided into rectangles.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_strips.h"

namespace ocelli {

/// Where no box fits a piece well, its largest rectangle becomes a room of its own, and so on with what is left; what
/// is thin beside a rectangle, and what has no place to stand, goes to its neighbours. `radius` is that of the agent,
/// in squares.
WalkLayout rectangularLayout(const WalkField& field, const WalkLayout& layout, int radius);

/// Whether one box fits squares well enough to be a cell of that shape: a room or a tunnel.
bool fitsBox(const WalkField& field, const std::vector<uint32_t>& squares, const WalkShape& shape);

}  // namespace ocelli
