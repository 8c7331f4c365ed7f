// Tunnels that are too short to be in, such as the passage through the thickness of a wall.
#pragma once

#include "oc_core/scene/walk_map.h"

namespace ocelli {

/// Where a tunnel is shorter than that and has an opening at each end alone, one portal in its middle takes its place.
/// Parts are not numbered anew.
void dissolveShortTunnels(WalkMap& map, float shortest);

}  // namespace ocelli
