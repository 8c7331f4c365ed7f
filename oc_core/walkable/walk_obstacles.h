// Small obstacles in open space: a lamp in a street or a table in a room does not divide it.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// Closes the holes that stand free and are small for the space that there is without them: lower ones than the agent's
/// eyes may be three quarters as long as the space is wide, and three times as long as the agent is high; others a
/// third and as long as that. `widest` is the limit of halfWidths() (walk_width.h).
WalkField overlookObstacles(const WalkField& field, float agentHeight, uint16_t widest);

}  // namespace ocelli
