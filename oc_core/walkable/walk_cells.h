// Pieces of floor as boxes and tunnels.
#pragma once

#include <vector>

#include "oc_core/scene/walk_map.h"
#include "oc_core/walkable/walk_strips.h"

namespace ocelli {

/// A cell for each piece, in the frame of the field: the box covers where the piece is at least half as wide and half
/// as long as it mostly is. Boxes of pieces that do not fit along the axes are turned. Where the middle of a room is
/// under a small obstacle, its box is made smaller around the nearest place to stand. Ceilings are a quartile from
/// below; where there is none, the height is the median of what stands around the cell, and twice the agent's where
/// nothing does.
std::vector<WalkCell> cellsOf(const WalkField& field, const WalkLayout& layout, float agentHeight);

}  // namespace ocelli
