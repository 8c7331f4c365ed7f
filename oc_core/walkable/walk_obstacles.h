// Small obstacles in open space: a lamp in a street or a table in a room does not divide it.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// Closes the holes that stand free and are small for the space around them. Lower ones than the agent's eyes may be
/// three quarters as long as the space is wide, others an eighth. `halfWidths` are those of the field (walk_width.h).
WalkField overlookObstacles(const WalkField& field, const std::vector<uint16_t>& halfWidths, float agentHeight);

}  // namespace ocelli
