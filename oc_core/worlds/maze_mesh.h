// What a maze looks like: floor, walls and landmarks, in metres.
#pragma once

#include "oc_core/scene/maze.h"
#include "oc_core/scene/scene.h"

namespace ocelli {

struct MazeLook {
  /// Walls and floor are grey, with a faint pattern, and walls along one axis are lighter than those along the other:
  /// nothing but landmarks catches the eye. Else each corridor has a colour and a pattern of its own.
  bool plain = false;
  bool closedEntrance = false;  ///< by a wall
  bool coarse = false;          ///< the same surfaces in as few triangles as they can have, so without patterns
};

/// Object 0 is the structure: floor and walls as one closed solid. Object i + 1 is landmark i, closed too. The guides
/// of the scene hold the maze. `maze` must be valid.
Scene makeMazeScene(const Maze& maze, const MazeLook& look = {});

}  // namespace ocelli
