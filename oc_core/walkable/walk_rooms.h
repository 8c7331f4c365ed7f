// Pieces of floor put together to rooms: those that joints (walk_joints.h) join. Where one box fits two of them, they
// become one piece; a room that no box fits keeps several.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_joints.h"

namespace ocelli {

/// Joins pieces that touch along joints, as long as one box fits them; the larger one says what both are. Tunnels,
/// crossings, turns and dead ends are not joined with each other.
WalkLayout mergedLayout(const JointSearch& search, const WalkLayout& layout);

/// Of each piece the number of its room: pieces of one number are joined by joints.
std::vector<uint32_t> roomsOf(const JointSearch& search, const WalkLayout& layout);

}  // namespace ocelli
