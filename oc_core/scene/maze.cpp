#include "oc_core/scene/maze.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"

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

glm::vec3 vectorOf(Direction direction) {
  switch (direction) {
    case Direction::kNorth:
      return {0, 0, -1};
    case Direction::kEast:
      return {1, 0, 0};
    case Direction::kSouth:
      return {0, 0, 1};
    case Direction::kWest:
      return {-1, 0, 0};
  }
  return glm::vec3(0);
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

MazeCell MazeCell::neighbor(Direction direction) const {
  const glm::vec3 step = vectorOf(direction);
  return {row + static_cast<int>(step.z), column + static_cast<int>(step.x)};
}

std::string nameOf(const MazeCell& cell) {
  return fmt::format("(row {}, column {})", cell.row, cell.column);
}

Maze::Maze(int rows, int columns)
    : rows_(rows), columns_(columns), open_(2 * static_cast<size_t>(rows) * static_cast<size_t>(columns), 0) {
  OC_CHECK(rows >= 1 && columns >= 1 && rows <= kMaxMazeSide && columns <= kMaxMazeSide,
           "who makes a maze checks its size");
}

bool Maze::contains(const MazeCell& cell) const {
  return cell.row >= 0 && cell.row < rows_ && cell.column >= 0 && cell.column < columns_;
}

size_t Maze::wallIndex(const MazeCell& cell, Direction direction) const {
  const bool far = direction == Direction::kNorth || direction == Direction::kWest;  // the neighbour keeps it
  const MazeCell keeper = far ? cell.neighbor(direction) : cell;
  OC_CHECK(contains(keeper), "a wall between two cells of the maze");
  return (isEastWest(direction) ? 0 : cellCount()) + indexOf(keeper);
}

bool Maze::isOpen(const MazeCell& cell, Direction direction) const {
  OC_CHECK(contains(cell), "a cell of the maze");
  return contains(cell.neighbor(direction)) && open_[wallIndex(cell, direction)] != 0;
}

void Maze::setOpen(const MazeCell& cell, Direction direction, bool open) {
  OC_CHECK(contains(cell) && contains(cell.neighbor(direction)), "passages join two cells of the maze");
  open_[wallIndex(cell, direction)] = open ? 1 : 0;
}

std::vector<Direction> Maze::passages(const MazeCell& cell) const {
  std::vector<Direction> list;
  for (const Direction direction : kDirections) {
    if (isOpen(cell, direction)) {
      list.push_back(direction);
    }
  }
  return list;
}

CellKind Maze::kind(const MazeCell& cell) const {
  const std::vector<Direction> ways = passages(cell);
  switch (ways.size()) {
    case 0:
      return CellKind::kClosed;
    case 1:
      return CellKind::kDeadEnd;
    case 2:
      return ways[1] == opposite(ways[0]) ? CellKind::kStraight : CellKind::kTurn;
    case 3:
      return CellKind::kThreeWay;
    default:
      return CellKind::kFourWay;
  }
}

std::optional<MazeCell> Maze::cellAt(const glm::vec3& point) const {
  const glm::vec3 inCells = (point - origin) / cellSize;
  // Written so that NaN is outside.
  if (!(inCells.x >= 0 && inCells.x < static_cast<float>(columns_) && inCells.z >= 0 &&
        inCells.z < static_cast<float>(rows_))) {
    return std::nullopt;
  }
  return MazeCell{static_cast<int>(inCells.z), static_cast<int>(inCells.x)};
}

bool Maze::isInWall(const glm::vec3& point) const {
  const glm::vec3 inCells = (point - origin) / cellSize;
  const float half = wallThickness / 2 / cellSize;
  // The nearest lines of the grid, which are where a wall can be.
  const float lineX = std::round(inCells.x);
  const float lineZ = std::round(inCells.z);
  const bool onX = std::abs(inCells.x - lineX) <= half;  // on a line that runs north to south
  const bool onZ = std::abs(inCells.z - lineZ) <= half;
  const auto within = [](float x, int least, int most) {
    return x >= static_cast<float>(least) && x <= static_cast<float>(most);
  };
  if (!((onX || onZ) && within(onX ? lineX : std::floor(inCells.x), 0, onX ? columns_ : columns_ - 1) &&
        within(onZ ? lineZ : std::floor(inCells.z), 0, onZ ? rows_ : rows_ - 1))) {
    return false;
  }
  if (onX && onZ) {
    return true;
  }
  // The cell to the east or south of the line, or to the other side at the border.
  MazeCell cell{static_cast<int>(onZ ? lineZ : std::floor(inCells.z)),
                static_cast<int>(onX ? lineX : std::floor(inCells.x))};
  Direction side = onX ? Direction::kWest : Direction::kNorth;
  if (!contains(cell)) {
    cell = cell.neighbor(side);
    side = opposite(side);
  }
  const bool isGap = entrance && entrance->cell == cell && opposite(entrance->heading) == side;
  return !isOpen(cell, side) && !(isGap && !contains(cell.neighbor(side)));
}

glm::vec3 Maze::centerOf(const MazeCell& cell) const {
  return origin + cellSize * glm::vec3(static_cast<float>(cell.column) + 0.5f, 0, static_cast<float>(cell.row) + 0.5f);
}

Box Maze::cellBox(const MazeCell& cell) const {
  const glm::vec3 center = centerOf(cell);
  return {center - glm::vec3(cellSize / 2, 0, cellSize / 2),
          center + glm::vec3(cellSize / 2, wallHeight, cellSize / 2)};
}

Box Maze::clearBox(const MazeCell& cell) const {
  const glm::vec3 center = centerOf(cell);
  const float half = (cellSize - wallThickness) / 2;
  return {center - glm::vec3(half, 0, half), center + glm::vec3(half, wallHeight, half)};
}

Portal Maze::openingOf(const MazeCell& cell, Direction direction) const {
  OC_CHECK(isOpen(cell, direction) || (entrance && entrance->cell == cell && opposite(entrance->heading) == direction),
           "an opening is asked for where there is one");
  const float half = (cellSize - wallThickness) / 2;
  Portal portal;
  portal.normal = -vectorOf(direction);
  portal.halfRight = vectorOf(rightOf(direction)) * half;
  portal.halfUp = {0, wallHeight / 2, 0};
  portal.center = centerOf(cell) + vectorOf(direction) * half + portal.halfUp;
  return portal;
}

std::vector<MazeCell> Maze::ahead(const MazeCell& cell, Direction direction) const {
  std::vector<MazeCell> cells;
  MazeCell at = cell;
  while (isOpen(at, direction)) {
    at = at.neighbor(direction);
    cells.push_back(at);
    if (kind(at) != CellKind::kStraight) {
      break;
    }
  }
  return cells;
}

Maze moved(const Maze& maze, const glm::mat4& newFromOld) {
  const float scale = newFromOld[0][0];
  OC_CHECK(scale > 0, "fitting a scene does not mirror it");
  Maze result = maze;
  result.cellSize *= scale;
  result.wallHeight *= scale;
  result.wallThickness *= scale;
  result.origin = glm::vec3(newFromOld * glm::vec4(maze.origin, 1));
  return result;
}

}  // namespace ocelli
