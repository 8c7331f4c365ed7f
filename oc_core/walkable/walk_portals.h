// The borders between pieces of floor as portals between cells.
#pragma once

#include <vector>

#include "oc_core/scene/walk_map.h"
#include "oc_core/walkable/walk_strips.h"

namespace ocelli {

/// A portal for each opening between two pieces: as wide as their border, and as high as the lower ceiling over it, or
/// the lower of both cells. Small obstacles in an opening do not part it. Openings that are narrower than the agent, of
/// 2 `radius` + 1 squares, are left out where others join the pieces. Between pieces of one room (walk_rooms.h) they
/// are joints.
std::vector<WalkPortal> portalsOf(const WalkField& field, const WalkLayout& layout, const std::vector<uint32_t>& rooms,
                                  const std::vector<WalkCell>& cells, int radius);

}  // namespace ocelli
