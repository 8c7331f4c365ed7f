// The floor of a maze as a stored protocol draws it. Metres as in the pose log: x to the east, z to the south, from the
// north-western corner, on the middle lines of the outer walls.
#pragma once

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/maze/maze_floor.h"

namespace ocelli {

/// Takes drawings that no study would: of any number of gaps, and of cells that cannot be reached. Throws InputError
/// that names the maze where its lines differ in length, are too few or too many, or have other characters than "+-| ".
MazeFloor floorOf(const ProtocolMaze& maze);

}  // namespace ocelli
