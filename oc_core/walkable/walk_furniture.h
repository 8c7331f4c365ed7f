// Low things, such as furniture along the walls of a room and cars: the floor below them belongs to the space that is
// seen over them, though one cannot stand there.
#pragma once

#include "oc_core/walkable/walk_columns.h"
#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// Adds squares (WalkSquare::isObstacle) where what stands beside the floor ends below the agent's eyes, and floor that
/// is too narrow beside it. Sills of windows, over which a wall goes on, things that are longer than five times the
/// agent's height, and those that part floor from floor, as fences and railings do, stay as they are.
WalkField seenOverFurniture(const WalkField& field, const WalkColumns& columns, float agentHeight, float stepHeight);

}  // namespace ocelli
