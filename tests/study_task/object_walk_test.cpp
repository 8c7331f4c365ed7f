#include "study/task/object_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "tests/study_task/study_tasks.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

glm::dvec2 middle(const Maze& maze, const MazeCell& cell) {
  const glm::vec3 center = maze.centerOf(cell);
  return {static_cast<double>(center.x), static_cast<double>(center.z)};
}

std::vector<ObjectWalk::Start> startsIn(const Maze& maze, size_t count, Random& random) {
  std::vector<ObjectWalk::Start> starts;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      starts.push_back({{row, column}, middle(maze, {row, column})});
    }
  }
  random.shuffle(starts);
  starts.resize(std::min(count, starts.size()));
  return starts;
}

TEST(ObjectWalk, goesFromMiddleToMiddleAtItsSpeed) {
  const Maze maze = test::studyMaze();
  // A dead end whose one way leads to the east.
  const ObjectWalk::Start start{{1, 0}, middle(maze, {1, 0})};
  ObjectWalk walk(maze, std::span(&start, 1), 1.5, 3);
  ASSERT_EQ(maze.passages({1, 0}).size(), 2u);
  for (int i = 0; i < 240; ++i) {
    walk.advance();
  }
  // Half of the 3 m that the way has.
  EXPECT_NEAR(glm::distance(walk.place(0), start.place), 1.5, 1e-9);
  for (int i = 0; i < 240; ++i) {
    walk.advance();
  }
  EXPECT_NEAR(glm::distance(walk.place(0), start.place), 3, 1e-9);
}

TEST(ObjectWalk, turnsBackInDeadEndsAlone) {
  const Maze maze = test::studyMaze();
  const ObjectWalk::Start start{{0, 0}, middle(maze, {0, 0}) + glm::dvec2(0.3, -0.2)};
  ObjectWalk walk(maze, std::span(&start, 1), 30, 9);  // 24 ticks a way
  std::vector<MazeCell> visited{start.cell};
  for (int i = 0; i < 24 * 3000; ++i) {
    if (visited.back() != walk.goal(0)) {
      visited.push_back(walk.goal(0));
    }
    walk.advance();
  }
  std::set<MazeCell> all(visited.begin(), visited.end());
  EXPECT_EQ(all.size(), maze.cellCount());
  for (size_t i = 1; i < visited.size(); ++i) {
    const std::vector<Direction> ways = maze.passages(visited[i - 1]);
    EXPECT_TRUE(std::any_of(ways.begin(), ways.end(),
                            [&](Direction way) { return visited[i - 1].neighbor(way) == visited[i]; }));
    if (i > 1 && visited[i] == visited[i - 2]) {
      EXPECT_EQ(maze.kind(visited[i - 1]), CellKind::kDeadEnd);
    }
  }
}

TEST(ObjectWalk, objectsKeepApart) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    Random random(seed);
    const std::vector<ObjectWalk::Start> starts = startsIn(maze, 7, random);
    ObjectWalk walk(maze, starts, 40, seed);
    for (int tick = 0; tick < 4000; ++tick) {
      for (size_t i = 0; i < walk.size(); ++i) {
        const glm::dvec2 place = walk.place(i);
        ASSERT_FALSE(maze.isInWall(glm::vec3(glm::dvec3(place.x, 0.1, place.y))));
        for (size_t k = 0; k < i; ++k) {
          // Ways that share no cell are a cell apart, whatever happens on them at the same time; places are floats.
          ASSERT_GE(glm::distance(place, walk.place(k)), static_cast<double>(maze.cellSize) - 1e-4)
              << "maze " << seed << ", tick " << tick;
        }
      }
      walk.advance();
    }
  }
}

TEST(ObjectWalk, isTheSameForTheSameSeed) {
  const Maze maze = test::studyMaze();
  Random random(4);
  const std::vector<ObjectWalk::Start> starts = startsIn(maze, 5, random);
  ObjectWalk one(maze, starts, 1, 1);
  ObjectWalk same(maze, starts, 1, 1);
  ObjectWalk other(maze, starts, 1, 2);
  bool differs = false;
  for (int i = 0; i < 10000; ++i) {
    one.advance();
    same.advance();
    other.advance();
    ASSERT_EQ(one.place(3), same.place(3));
    differs = differs || one.place(3) != other.place(3);
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace ocelli
