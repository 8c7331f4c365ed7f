// The cross sections of a tunnel: how far its walls and its ceiling are, all along.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/walk_map.h"
#include "oc_core/walkable/walk_box.h"

namespace ocelli {

/// Rings along the box, from its beginning to its end, as few as follow the walls to one and a half squares: facades
/// that are not aligned have two rings close to each other where they step. `height` is that of places without ceiling
/// and without walls.
std::vector<WalkRing> ringsOf(const WalkField& field, const std::vector<uint32_t>& squares, const WalkBox& box,
                              float height);

}  // namespace ocelli
