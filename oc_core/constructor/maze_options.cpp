#include "oc_core/constructor/maze_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {

void checkCell(const Maze& maze, const MazeCell& cell, const std::string& where) {
  if (!maze.contains(cell)) {
    throw InputError("the cell " + nameOf(cell) + " is not in the maze", where,
                     fmt::format("rows are 0 to {}, columns 0 to {}", maze.rows() - 1, maze.columns() - 1));
  }
}

Direction nearestDirection(const glm::vec3& vector) {
  return *std::max_element(kDirections.begin(), kDirections.end(), [&](Direction a, Direction b) {
    return glm::dot(vector, vectorOf(a)) < glm::dot(vector, vectorOf(b));
  });
}

std::optional<Direction> readDirection(JsonFields& fields, const std::string& name) {
  if (!fields.has(name)) {
    return std::nullopt;
  }
  const std::string text = fields.text(name);
  for (const Direction direction : kDirections) {
    if (text == nameOf(direction)) {
      return direction;
    }
  }
  fields.fail(name, "is \"" + text + "\", but must be north, east, south or west");
}

}  // namespace ocelli
