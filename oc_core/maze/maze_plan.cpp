#include "oc_core/maze/maze_plan.h"

#include "oc_core/base/check.h"

namespace ocelli {

MazePlan::MazePlan(int rows, int columns)
    : rows_(rows), columns_(columns), open_(2 * static_cast<size_t>(rows) * static_cast<size_t>(columns), 0) {
  OC_CHECK(rows >= 1 && columns >= 1 && rows <= kMaxMazeSide && columns <= kMaxMazeSide,
           "who makes a maze checks its size");
}

bool MazePlan::contains(const MazeCell& cell) const {
  return cell.row >= 0 && cell.row < rows_ && cell.column >= 0 && cell.column < columns_;
}

size_t MazePlan::wallIndex(const MazeCell& cell, Direction direction) const {
  const bool far = direction == Direction::kNorth || direction == Direction::kWest;  // the neighbour keeps it
  const MazeCell keeper = far ? cell.neighbor(direction) : cell;
  OC_CHECK(contains(keeper), "a wall between two cells of the maze");
  return (isEastWest(direction) ? 0 : cellCount()) + indexOf(keeper);
}

bool MazePlan::isOpen(const MazeCell& cell, Direction direction) const {
  OC_CHECK(contains(cell), "a cell of the maze");
  return contains(cell.neighbor(direction)) && open_[wallIndex(cell, direction)] != 0;
}

void MazePlan::setOpen(const MazeCell& cell, Direction direction, bool open) {
  OC_CHECK(contains(cell) && contains(cell.neighbor(direction)), "passages join two cells of the maze");
  open_[wallIndex(cell, direction)] = open ? 1 : 0;
}

std::vector<Direction> MazePlan::passages(const MazeCell& cell) const {
  std::vector<Direction> list;
  for (const Direction direction : kDirections) {
    if (isOpen(cell, direction)) {
      list.push_back(direction);
    }
  }
  return list;
}

CellKind MazePlan::kind(const MazeCell& cell) const {
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

std::vector<MazeCell> MazePlan::ahead(const MazeCell& cell, Direction direction) const {
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

std::vector<std::optional<int>> MazePlan::shortestStepsFrom(const MazeCell& from) const {
  OC_CHECK(contains(from), "ways start in a cell of the maze");
  std::vector<std::optional<int>> steps(cellCount());
  std::vector<MazeCell> reached{from};  // the nearest first
  steps[indexOf(from)] = 0;
  for (size_t i = 0; i < reached.size(); ++i) {
    const MazeCell cell = reached[i];
    for (const Direction direction : passages(cell)) {
      const MazeCell next = cell.neighbor(direction);
      if (!steps[indexOf(next)]) {
        steps[indexOf(next)] = *steps[indexOf(cell)] + 1;
        reached.push_back(next);
      }
    }
  }
  return steps;
}

std::optional<int> MazePlan::shortestSteps(const MazeCell& from, const MazeCell& to) const {
  return contains(from) && contains(to) ? shortestStepsFrom(from)[indexOf(to)] : std::nullopt;
}

}  // namespace ocelli
