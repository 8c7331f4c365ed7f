#include "oc_core/worlds/maze_validate.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {
namespace {

void checkSizes(const Maze& maze, const std::string& where) {
  if (maze.rows() * maze.columns() < 2) {
    throw InputError("a maze of one cell has no passage", where, "give it two cells or more");
  }
  const auto isLength = [](float x) { return std::isfinite(x) && x > 0; };
  if (!isLength(maze.cellSize) || !isLength(maze.wallHeight) || !isLength(maze.wallThickness)) {
    throw InputError("a size of the maze is not a positive number", where, "give positive lengths in metres");
  }
  if (maze.wallThickness > maze.cellSize / 2) {
    throw InputError(fmt::format("the walls are {:g} thick, more than half of a cell of {:g}, which leaves no passage",
                                 maze.wallThickness, maze.cellSize),
                     where, "make the walls thinner or the cells larger");
  }
}

void checkEntrance(const Maze& maze, const std::string& where) {
  if (!maze.entrance) {
    throw InputError("the maze has no entrance", where, "leave one gap in the outer wall");
  }
  const MazeCell& cell = maze.entrance->cell;
  if (!maze.contains(cell)) {
    throw InputError(fmt::format("the entrance {} lies outside of the maze, which has {} rows and {} columns",
                                 nameOf(cell), maze.rows(), maze.columns()),
                     where, "rows and columns count from 0");
  }
  const Direction side = opposite(maze.entrance->heading);
  if (maze.contains(cell.neighbor(side))) {
    throw InputError(
        fmt::format("the entrance {} has another cell, not the outer wall, in the {}", nameOf(cell), nameOf(side)),
        where, "put the entrance at the border, and turn its heading inwards");
  }
}

void checkReachability(const Maze& maze, const std::string& where) {
  const std::vector<std::optional<int>> steps = maze.shortestStepsFrom(maze.entrance->cell);
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      if (!steps[maze.indexOf({row, column})]) {
        throw InputError(fmt::format("the cell {} cannot be reached from the entrance", nameOf(MazeCell{row, column})),
                         where, "open a wall that closes it off");
      }
    }
  }
}

void checkLandmark(const Maze& maze, size_t i, const std::string& where) {
  const Landmark& landmark = maze.landmarks[i];
  const std::string name =
      fmt::format("landmark {} (a {} in the cell {})", i + 1, nameOf(landmark.shape), nameOf(landmark.cell));
  if (!maze.contains(landmark.cell)) {
    throw InputError(
        fmt::format("{} lies outside of the maze, which has {} rows and {} columns", name, maze.rows(), maze.columns()),
        where, "rows and columns count from 0");
  }
  if (landmark.shape == LandmarkShape::kArch) {
    const CellKind kind = maze.kind(landmark.cell);
    if (kind != CellKind::kStraight && kind != CellKind::kDeadEnd) {
      throw InputError(name + " has no passage to span: an arch stands in a straight cell or a dead end", where,
                       "move it, or choose another shape");
    }
    if (landmark.east != 0 || landmark.south != 0) {
      throw InputError(name + " is moved, but an arch spans the middle of its cell", where, "leave its offset out");
    }
    return;
  }
  // Written so that NaN is refused.
  const float reach = 0.5f - maze.wallThickness / 2 / maze.cellSize - kLandmarkRadius;
  if (!(std::abs(landmark.east) <= reach && std::abs(landmark.south) <= reach)) {
    throw InputError(fmt::format("{} reaches into a wall or out of its cell", name), where,
                     fmt::format("keep its offset within {:.3g} cell sizes", std::max(reach, 0.0f)));
  }
}

}  // namespace

void validate(const Maze& maze, const std::string& where) {
  checkSizes(maze, where);
  checkEntrance(maze, where);
  checkReachability(maze, where);
  for (size_t i = 0; i < maze.landmarks.size(); ++i) {
    checkLandmark(maze, i, where);
  }
}

}  // namespace ocelli
