// The portals of a maze: the mouths of the corridors that meet at its turns and crossings.
#pragma once

#include <vector>

#include "oc_core/scene/maze.h"

namespace ocelli {

/// The openings of turns and crossings that a straight line from the eye reaches between the walls, seen from within
/// their cell. Those with the eye behind them are left out. An eye above the walls, or outside of the maze, sees all it
/// is before. Throws InputError where the eye is in a wall.
std::vector<Portal> openingsInSight(const Maze& maze, const glm::vec3& eye);

}  // namespace ocelli
