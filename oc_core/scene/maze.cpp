#include "oc_core/scene/maze.h"

#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {

glm::vec3 vectorOf(Direction direction) {
  const CellStep step = stepOf(direction);
  return {step.columns, 0, step.rows};
}

std::optional<MazeCell> Maze::cellAt(const glm::vec3& point) const {
  const glm::vec3 inCells = (point - origin) / cellSize;
  // Written so that NaN is outside.
  if (!(inCells.x >= 0 && inCells.x < static_cast<float>(columns()) && inCells.z >= 0 &&
        inCells.z < static_cast<float>(rows()))) {
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
  if (!((onX || onZ) && within(onX ? lineX : std::floor(inCells.x), 0, onX ? columns() : columns() - 1) &&
        within(onZ ? lineZ : std::floor(inCells.z), 0, onZ ? rows() : rows() - 1))) {
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
