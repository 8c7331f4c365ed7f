#include "oc_core/worlds/maze_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_graph.h"
#include "oc_core/worlds/maze_validate.h"

namespace ocelli {
namespace {

constexpr const char* kWhere = "generated maze";

std::vector<MazeCell> allCells(const Maze& maze) {
  std::vector<MazeCell> cells;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      cells.push_back({row, column});
    }
  }
  return cells;
}

size_t countOf(const Maze& maze, CellKind kind) {
  const std::vector<MazeCell> cells = allCells(maze);
  return static_cast<size_t>(
      std::count_if(cells.begin(), cells.end(), [&](const MazeCell& cell) { return maze.kind(cell) == kind; }));
}

/// Which cells hang together, while passages are opened one after the other.
class Components {
 public:
  explicit Components(const Maze& maze) : columns_(static_cast<size_t>(maze.columns())) {
    for (size_t i = 0; i < maze.cellCount(); ++i) {
      of_.push_back(i);
    }
  }
  size_t of(const MazeCell& cell) const {
    return of_[static_cast<size_t>(cell.row) * columns_ + static_cast<size_t>(cell.column)];
  }
  void join(const MazeCell& a, const MazeCell& b) { std::replace(of_.begin(), of_.end(), of(a), size_t{of(b)}); }

 private:
  size_t columns_;
  std::vector<size_t> of_;
};

/// Turns random cells into crossings of so many ways, each to a part of the maze that hangs together with no other.
void openCrossings(Maze& maze, Components& components, size_t ways, size_t count, Random& random) {
  const CellKind kind = ways == 4 ? CellKind::kFourWay : CellKind::kThreeWay;
  std::vector<MazeCell> cells = allCells(maze);
  random.shuffle(cells);
  for (const MazeCell& cell : cells) {
    if (countOf(maze, kind) >= count) {
      return;
    }
    std::vector<Direction> sides(kDirections.begin(), kDirections.end());
    random.shuffle(sides);
    const size_t open = maze.passages(cell).size();
    std::vector<Direction> chosen;
    for (const Direction side : sides) {
      const MazeCell next = cell.neighbor(side);
      const auto isApart = [&](const MazeCell& other) { return components.of(next) != components.of(other); };
      if (maze.contains(next) && maze.passages(next).size() < 3 && isApart(cell) &&
          std::all_of(chosen.begin(), chosen.end(), [&](Direction d) { return isApart(cell.neighbor(d)); }) &&
          open + chosen.size() < ways) {
        chosen.push_back(side);
      }
    }
    if (open + chosen.size() == ways) {
      for (const Direction side : chosen) {
        maze.setOpen(cell, side, true);
        components.join(cell, cell.neighbor(side));
      }
    }
  }
}

/// Depth first search: on to a random neighbour that was not reached yet, back where there is none. What hangs together
/// already is reached at once.
void openSpanningTree(Maze& maze, Components& components, Random& random) {
  const MazeCell entrance = maze.entrance->cell;
  const auto cellsWith = [&](const MazeCell& cell) {
    std::vector<MazeCell> cells = allCells(maze);
    std::erase_if(cells, [&](const MazeCell& other) { return components.of(other) != components.of(cell); });
    random.shuffle(cells);
    return cells;
  };
  std::vector<MazeCell> way = cellsWith(entrance);
  while (!way.empty()) {
    const MazeCell cell = way.back();
    std::vector<Direction> free;
    for (const Direction direction : kDirections) {
      const MazeCell next = cell.neighbor(direction);
      if (maze.contains(next) && components.of(next) != components.of(entrance)) {
        free.push_back(direction);
      }
    }
    if (free.empty()) {
      way.pop_back();
      continue;
    }
    const Direction direction = free[random.below(free.size())];
    const MazeCell next = cell.neighbor(direction);
    const std::vector<MazeCell> reached = cellsWith(next);
    way.insert(way.end(), reached.begin(), reached.end());
    maze.setOpen(cell, direction, true);
    components.join(next, entrance);
  }
}

/// Walls at the post to the south-east of `cell`.
int wallsAtPost(const Maze& maze, const MazeCell& cell) {
  const MazeCell across{cell.row + 1, cell.column + 1};
  if (!maze.contains(cell) || !maze.contains(across)) {
    return 4;  // the outer wall
  }
  return static_cast<int>(!maze.isOpen(cell, Direction::kEast)) +
         static_cast<int>(!maze.isOpen(cell, Direction::kSouth)) +
         static_cast<int>(!maze.isOpen(across, Direction::kNorth)) +
         static_cast<int>(!maze.isOpen(across, Direction::kWest));
}

/// Opens the wall, if there is one within the maze, unless it is the last one at a post.
bool openWall(Maze& maze, const MazeWall& wall) {
  if (!maze.contains(wall.cell.neighbor(wall.side)) || maze.isOpen(wall.cell, wall.side)) {
    return false;
  }
  // The wall on the east or south of `keeper` ends at the post to its south-east and at the one before that.
  const bool far = wall.side == Direction::kNorth || wall.side == Direction::kWest;
  const MazeCell keeper = far ? wall.cell.neighbor(wall.side) : wall.cell;
  const Direction toOtherPost = isEastWest(wall.side) ? Direction::kNorth : Direction::kWest;
  if (wallsAtPost(maze, keeper) < 2 || wallsAtPost(maze, keeper.neighbor(toOtherPost)) < 2) {
    return false;
  }
  maze.setOpen(wall.cell, wall.side, true);
  return true;
}

void openLoops(Maze& maze, double share, Random& random) {
  std::vector<MazeWall> walls;
  for (const MazeCell& cell : allCells(maze)) {
    for (const Direction side : {Direction::kEast, Direction::kSouth}) {
      if (maze.contains(cell.neighbor(side)) && !maze.isOpen(cell, side)) {
        walls.push_back({cell, side});
      }
    }
  }
  random.shuffle(walls);
  auto wanted = static_cast<size_t>(std::lround(share * static_cast<double>(walls.size())));
  for (const MazeWall& wall : walls) {
    if (wanted > 0 && openWall(maze, wall)) {
      --wanted;
    }
  }
}

/// Opens all walls of a cell within the maze, or none of them.
void openAround(Maze& maze, const MazeCell& cell) {
  const Maze before = maze;
  for (const Direction side : kDirections) {
    if (!maze.isOpen(cell, side) && !openWall(maze, {cell, side})) {
      maze = before;
      return;
    }
  }
}

/// Where the crossings that were made first are too few: more, at the price of loops.
void addCrossings(Maze& maze, const MazeOptions& options, Random& random) {
  std::vector<MazeCell> cells = allCells(maze);
  random.shuffle(cells);
  for (const MazeCell& cell : cells) {
    if (countOf(maze, CellKind::kFourWay) >= options.minFourWay) {
      break;
    }
    openAround(maze, cell);
  }
  // A third way for cells of two, where it makes no neighbour of three ways one of four.
  for (const MazeCell& cell : cells) {
    if (countOf(maze, CellKind::kThreeWay) >= options.minThreeWay) {
      break;
    }
    for (const Direction side : kDirections) {
      const MazeCell next = cell.neighbor(side);
      if (maze.passages(cell).size() == 2 && maze.contains(next) && maze.passages(next).size() <= 2) {
        openWall(maze, {cell, side});
      }
    }
  }
  const auto check = [&](CellKind kind, size_t least, const char* ways) {
    const size_t count = countOf(maze, kind);
    if (count < least) {
      throw InputError(fmt::format("{} crossings of {} ways are asked for, and a maze of {} x {} cells got {}", least,
                                   ways, maze.rows(), maze.columns(), count),
                       kWhere, "ask for fewer, take a larger maze, or try another seed");
    }
  };
  check(CellKind::kFourWay, options.minFourWay, "4");
  check(CellKind::kThreeWay, options.minThreeWay, "3");
}

/// Beside the way in a straight cell, in the middle of a dead end, in the corner of a turn, and so on: where there is a
/// wall to stand at.
Landmark placed(const Maze& maze, const MazeCell& cell, Random& random) {
  Landmark landmark;
  landmark.cell = cell;
  landmark.color = kLandmarkColors[random.below(kLandmarkColors.size())];
  // The arch, which is the last, only where there is a passage to span.
  landmark.shape =
      kLandmarkShapes[random.below(kLandmarkShapes.size() - (maze.kind(cell) == CellKind::kStraight ? 0 : 1))];
  if (landmark.shape != LandmarkShape::kArch && maze.kind(cell) != CellKind::kDeadEnd) {
    const float reach = 0.45f - maze.wallThickness / 2 / maze.cellSize - kLandmarkRadius;
    std::vector<Direction> sides;
    for (const Direction side : kDirections) {
      if (!maze.isOpen(cell, side) && !(maze.entrance->cell == cell && opposite(maze.entrance->heading) == side)) {
        sides.push_back(side);
      }
    }
    if (!sides.empty()) {
      const glm::vec3 offset = vectorOf(sides[random.below(sides.size())]) * reach;
      landmark.east = offset.x;
      landmark.south = offset.z;
    }
  }
  return landmark;
}

void placeLandmarks(Maze& maze, size_t count, Random& random) {
  // First a cell of each corridor, then all others; crossings, where they would stand in the way, come last.
  std::vector<MazeCell> order;
  const auto add = [&](const MazeCell& cell) {
    if (std::find(order.begin(), order.end(), cell) == order.end()) {
      order.push_back(cell);
    }
  };
  const auto isCrossing = [&](const MazeCell& cell) {
    const CellKind kind = maze.kind(cell);
    return kind == CellKind::kThreeWay || kind == CellKind::kFourWay;
  };
  std::vector<Corridor> corridors = MazeGraph(maze).corridors;
  random.shuffle(corridors);
  for (Corridor& corridor : corridors) {
    random.shuffle(corridor.cells);
    const auto free = std::find_if_not(corridor.cells.begin(), corridor.cells.end(), isCrossing);
    if (free != corridor.cells.end()) {
      add(*free);
    }
  }
  std::vector<MazeCell> cells = allCells(maze);
  random.shuffle(cells);
  std::stable_partition(cells.begin(), cells.end(), [&](const MazeCell& cell) { return !isCrossing(cell); });
  for (const MazeCell& cell : cells) {
    add(cell);
  }
  for (size_t i = 0; i < count; ++i) {
    maze.landmarks.push_back(placed(maze, order[i], random));
  }
}

}  // namespace

Maze generateMaze(const MazeOptions& options) {
  if (options.rows < 1 || options.columns < 1 || options.rows > kMaxMazeSide || options.columns > kMaxMazeSide) {
    throw InputError(fmt::format("a maze of {} x {} cells is out of range", options.rows, options.columns), kWhere,
                     fmt::format("give 1 to {} rows and columns", kMaxMazeSide));
  }
  if (!(options.loops >= 0 && options.loops <= 1)) {
    throw InputError("the share of walls to open again is not from 0 to 1", kWhere, "0 makes no loops, 0.15 a few");
  }
  const size_t cells = static_cast<size_t>(options.rows) * static_cast<size_t>(options.columns);
  if (options.landmarks > cells) {
    throw InputError(fmt::format("{} landmarks are asked for, in {} cells", options.landmarks, cells), kWhere,
                     "ask for fewer landmarks or more cells");
  }
  Random random(options.seed);
  Maze maze(options.rows, options.columns);
  maze.entrance = {{options.rows - 1, static_cast<int>(random.below(static_cast<size_t>(options.columns)))},
                   Direction::kNorth};
  Components components(maze);
  openCrossings(maze, components, 4, options.minFourWay, random);
  openCrossings(maze, components, 3, options.minThreeWay, random);
  openSpanningTree(maze, components, random);
  openLoops(maze, options.loops, random);
  addCrossings(maze, options, random);
  placeLandmarks(maze, options.landmarks, random);
  validate(maze, kWhere);
  return maze;
}

}  // namespace ocelli
