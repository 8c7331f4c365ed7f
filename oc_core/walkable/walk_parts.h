// Which cells of a map are connected.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/walk_map.h"

namespace ocelli {

/// WalkMap::partOfCell: parts are numbered from 0 on, in order of their first cells.
std::vector<uint32_t> connectedParts(const WalkMap& map);

}  // namespace ocelli
