// What a maze looks like: floor, walls and landmarks, in metres.
#pragma once

#include "oc_core/scene/maze.h"
#include "oc_core/scene/scene.h"

namespace ocelli {

/// Object 0 is the structure: floor and walls as one closed solid with a pattern of its own on the walls of each
/// corridor. Object i + 1 is landmark i, closed too. The guides of the scene hold the maze. `maze` must be valid.
Scene makeMazeScene(const Maze& maze);

}  // namespace ocelli
