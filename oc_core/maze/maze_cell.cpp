#include "oc_core/maze/maze_cell.h"

#include <fmt/format.h>

namespace ocelli {

Direction rightOf(Direction direction) {
  return static_cast<Direction>((static_cast<int>(direction) + 1) % 4);
}

Direction leftOf(Direction direction) {
  return static_cast<Direction>((static_cast<int>(direction) + 3) % 4);
}

Direction opposite(Direction direction) {
  return static_cast<Direction>((static_cast<int>(direction) + 2) % 4);
}

bool isEastWest(Direction direction) {
  return direction == Direction::kEast || direction == Direction::kWest;
}

const char* nameOf(Direction direction) {
  switch (direction) {
    case Direction::kNorth:
      return "north";
    case Direction::kEast:
      return "east";
    case Direction::kSouth:
      return "south";
    case Direction::kWest:
      return "west";
  }
  return "";
}

CellStep stepOf(Direction direction) {
  switch (direction) {
    case Direction::kNorth:
      return {-1, 0};
    case Direction::kEast:
      return {0, 1};
    case Direction::kSouth:
      return {1, 0};
    case Direction::kWest:
      return {0, -1};
  }
  return {};
}

MazeCell MazeCell::neighbor(Direction direction) const {
  const CellStep step = stepOf(direction);
  return {row + step.rows, column + step.columns};
}

std::string nameOf(const MazeCell& cell) {
  return fmt::format("(row {}, column {})", cell.row, cell.column);
}

}  // namespace ocelli
