// The walk map of a grid maze: its turns, crossings and dead ends as rooms, its straight corridors between them as
// tunnels. Its openings are those of the maze (Maze::openingOf), in the middle of the passage between two cells.
#pragma once

#include "oc_core/scene/maze.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

WalkMap walkMapOf(const Maze& maze);

}  // namespace ocelli
