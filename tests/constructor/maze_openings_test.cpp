#include "oc_core/constructor/maze_openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

/// Two corridors that cross in the middle of 3 x 3 cells of 3 m; the corners are closed.
Maze crossing() {
  Maze maze(3, 3);
  for (const Direction direction : kDirections) {
    maze.setOpen({1, 1}, direction, true);
  }
  return maze;
}

bool holds(const std::vector<Portal>& portals, const Portal& wanted) {
  return std::any_of(portals.begin(), portals.end(),
                     [&](const Portal& each) { return each.center == wanted.center && each.normal == wanted.normal; });
}

TEST(MazeOpenings, fromACorridorOneSeesTheSideCorridorsAndTheOneAhead) {
  const Maze maze = crossing();
  const std::vector<Portal> seen = openingsInSight(maze, {1.0f, 1.5f, 4.5f});  // in the west
  EXPECT_EQ(seen.size(), 3u);
  for (const Direction direction : {Direction::kNorth, Direction::kEast, Direction::kSouth}) {
    EXPECT_TRUE(holds(seen, maze.openingOf({1, 1}, direction))) << nameOf(direction);
  }
  EXPECT_EQ(openingsInSight(maze, {4.5f, 1.5f, 4.5f}).size(), 4u);
}

TEST(MazeOpenings, wallsHideAndHeightUncovers) {
  Maze maze = crossing();
  maze.setOpen({0, 0}, Direction::kEast, true);  // from the north cell a corridor to the west: that cell is a turn
  const Portal hidden = maze.openingOf({0, 1}, Direction::kWest);
  EXPECT_FALSE(holds(openingsInSight(maze, {1.0f, 1.5f, 4.5f}), hidden));
  EXPECT_TRUE(holds(openingsInSight(maze, {4.5f, 1.5f, 7.5f}), hidden));
  EXPECT_FALSE(holds(openingsInSight(maze, {1.0f, 2.5f, 4.5f}), hidden));  // from above, but behind it
  EXPECT_TRUE(holds(openingsInSight(maze, {4.5f, 2.5f, 4.5f}), hidden));
  EXPECT_TRUE(holds(openingsInSight(maze, {20, 1.5f, 4.5f}), hidden));  // from outside
}

TEST(MazeOpenings, anEyeInAWallIsRefused) {
  EXPECT_THROW(openingsInSight(crossing(), {3, 1.5f, 1.5f}), InputError);
  EXPECT_NO_THROW(openingsInSight(crossing(), {3, 3, 1.5f}));
}

/// The slow way: points across each opening, and whether all of the straight line to them is free.
TEST(MazeOpenings, areThoseThatFreeLinesReach) {
  Random random(3);
  size_t reached = 0;
  size_t listed = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    const float x = random.inRange(0, static_cast<float>(maze.columns()) * maze.cellSize);
    const glm::vec3 eye(x, 1, random.inRange(0, static_cast<float>(maze.rows()) * maze.cellSize));
    if (maze.isInWall(eye)) {
      continue;
    }
    const auto isFree = [&](const glm::vec3& point) {
      const float steps = std::ceil(glm::distance(eye, point) / 0.03f);
      for (float step = 0; step <= steps; ++step) {
        if (maze.isInWall(eye + (point - eye) * (step / steps))) {
          return false;
        }
      }
      return true;
    };
    const std::vector<Portal> seen = openingsInSight(maze, eye);
    listed += seen.size();
    for (int row = 0; row < maze.rows(); ++row) {
      for (int column = 0; column < maze.columns(); ++column) {
        const MazeCell cell{row, column};
        const CellKind kind = maze.kind(cell);
        if (kind != CellKind::kTurn && kind != CellKind::kThreeWay && kind != CellKind::kFourWay) {
          continue;
        }
        for (const Direction direction : maze.passages(cell)) {
          const Portal opening = maze.openingOf(cell, direction);
          bool free = false;
          for (int i = 1; i < 60 && !free; ++i) {
            const glm::vec3 point = opening.center + opening.halfRight * (static_cast<float>(i) / 30 - 1);
            free = glm::dot(opening.normal, eye - point) > 0 && isFree(glm::vec3(point.x, eye.y, point.z));
          }
          if (free) {
            ++reached;
            EXPECT_TRUE(holds(seen, opening)) << "seed " << seed << " " << nameOf(cell) << " " << nameOf(direction);
          }
        }
      }
    }
  }
  EXPECT_GT(reached, 100u);
  // The others are seen through slits narrower than a sixtieth of the opening.
  EXPECT_LE(static_cast<double>(listed - reached), 0.05 * static_cast<double>(listed));
}

}  // namespace
}  // namespace ocelli
