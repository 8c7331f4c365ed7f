// What the constructors of cameras in mazes read from JSON and check alike.
#pragma once

#include <optional>
#include <string>

#include "oc_core/scene/maze.h"

namespace ocelli {

class JsonFields;

/// Throws InputError naming the cell where it is not in the maze.
void checkCell(const Maze& maze, const MazeCell& cell, const std::string& where);

/// The direction that is closest to a vector.
Direction nearestDirection(const glm::vec3& vector);

/// A field "north", "east", "south" or "west"; nothing where it is missing.
std::optional<Direction> readDirection(JsonFields& fields, const std::string& name);

}  // namespace ocelli
