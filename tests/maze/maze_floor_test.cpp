#include "oc_core/maze/maze_floor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace ocelli {
namespace {

struct DrawnMaze {
  std::vector<std::string> lines;
  double cellSize = 0;
  double wallThickness = 0;

  MazeFloor floor() const { return {readAnyDrawing(lines), {cellSize, wallThickness}}; }
};

DrawnMaze smallMaze() {
  return {{"+-+-+-+", "|     |", "+ +-+ +", "|   | |", "+ +-+-+"}, 2, 0.2};
}

DrawnMaze randomMaze(std::mt19937_64& random) {
  DrawnMaze maze{std::vector<std::string>(11, std::string(13, ' ')), 1.5, 0.3};
  for (size_t line = 0; line < 11; ++line) {
    for (size_t i = 0; i < 13; ++i) {
      const bool isBorder = line == 0 || i == 0 || line == 10 || i == 12;
      if (line % 2 == 0 && i % 2 == 0) {
        maze.lines[line][i] = '+';
      } else if ((line % 2 == 0 || i % 2 == 0) && (isBorder || random() % 5 < 2)) {
        maze.lines[line][i] = line % 2 == 0 ? '-' : '|';
      }
    }
  }
  return maze;
}

/// Whether a wall or post stands at the point, by the drawing alone.
bool isInWall(const DrawnMaze& maze, double x, double z) {
  const double half = maze.wallThickness / 2;
  for (size_t line = 0; line < maze.lines.size(); ++line) {
    for (size_t i = 0; i < maze.lines[line].size(); ++i) {
      const char c = maze.lines[line][i];
      const double left = static_cast<double>(i / 2) * maze.cellSize;
      const double top = static_cast<double>(line / 2) * maze.cellSize;
      const double right = c == '-' ? left + maze.cellSize : left;
      const double bottom = c == '|' ? top + maze.cellSize : top;
      if (c != ' ' && x >= left - half && x <= right + half && z >= top - half && z <= bottom + half) {
        return true;
      }
    }
  }
  return false;
}

TEST(MazeFloor, waysInASmallMaze) {
  const MazeFloor floor = smallMaze().floor();
  EXPECT_EQ(floor.plan().rows(), 2);
  EXPECT_EQ(floor.plan().columns(), 3);
  EXPECT_EQ(floor.shortestMeters({0, 0}, {0, 0}), 0.0);
  EXPECT_EQ(floor.shortestMeters({0, 0}, {0, 2}), 4.0);
  EXPECT_EQ(floor.shortestMeters({1, 1}, {1, 2}), 10.0);  // around: west, north, east, east, south
  EXPECT_FALSE(floor.shortestMeters({0, 0}, {7, 7}));
  EXPECT_EQ(floor.cellAt({3.9, 0.1}), (MazeCell{0, 1}));
  EXPECT_FALSE(floor.cellAt({-0.1, 1}));
  EXPECT_FALSE(floor.cellAt({1, 4.1}));
  EXPECT_EQ(floor.grid().pointOf({1, 2}, 0.25, -0.25).x, 5.5);
  EXPECT_EQ(floor.grid().pointOf({1, 2}, 0.25, -0.25).z, 2.5);
}

TEST(MazeFloor, shortestWaysAreThoseOfAllPairs) {
  std::mt19937_64 random(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const DrawnMaze maze = randomMaze(random);
    const MazeFloor floor = maze.floor();
    const int count = floor.plan().rows() * floor.plan().columns();
    // Floyd and Warshall over the cells; cells beside each other are joined where no wall is drawn between.
    std::vector<std::vector<double>> meters(static_cast<size_t>(count),
                                            std::vector<double>(static_cast<size_t>(count), 1e9));
    for (int a = 0; a < count; ++a) {
      const int row = a / floor.plan().columns();
      const int column = a % floor.plan().columns();
      const auto join = [&](int b) {
        meters[static_cast<size_t>(a)][static_cast<size_t>(b)] = maze.cellSize;
        meters[static_cast<size_t>(b)][static_cast<size_t>(a)] = maze.cellSize;
      };
      meters[static_cast<size_t>(a)][static_cast<size_t>(a)] = 0;
      if (column + 1 < floor.plan().columns() &&
          maze.lines[static_cast<size_t>(2 * row + 1)][static_cast<size_t>(2 * column + 2)] == ' ') {
        join(a + 1);
      }
      if (row + 1 < floor.plan().rows() &&
          maze.lines[static_cast<size_t>(2 * row + 2)][static_cast<size_t>(2 * column + 1)] == ' ') {
        join(a + floor.plan().columns());
      }
    }
    for (size_t k = 0; k < meters.size(); ++k) {
      for (auto& from : meters) {
        for (size_t b = 0; b < meters.size(); ++b) {
          from[b] = std::min(from[b], from[k] + meters[k][b]);
        }
      }
    }
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        const auto shortest = floor.shortestMeters({a / floor.plan().columns(), a % floor.plan().columns()},
                                                   {b / floor.plan().columns(), b % floor.plan().columns()});
        const double expected = meters[static_cast<size_t>(a)][static_cast<size_t>(b)];
        EXPECT_EQ(shortest.has_value(), expected < 1e9);
        if (shortest) {
          EXPECT_NEAR(*shortest, expected, 1e-9);
        }
      }
    }
  }
}

TEST(MazeFloor, sightIsWhatSmallStepsMeet) {
  std::mt19937_64 random(4);
  const auto uniform = [&](double most) { return most * static_cast<double>(random() >> 11U) * 0x1p-53; };
  int clear = 0;
  int hidden = 0;
  for (int repeat = 0; repeat < 30; ++repeat) {
    const DrawnMaze maze = randomMaze(random);
    const MazeFloor floor = maze.floor();
    for (int pair = 0; pair < 100; ++pair) {
      const FloorPoint from{uniform(9), uniform(7.5)};
      const FloorPoint to{uniform(9), uniform(7.5)};
      const bool isClear = floor.isClear(from, to);
      constexpr int kSteps = 4000;
      bool meetsWall = false;
      for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        meetsWall = meetsWall || isInWall(maze, from.x + share * (to.x - from.x), from.z + share * (to.z - from.z));
      }
      // Steps of 3 mm can jump over a corner, so the other way round is not always so.
      if (meetsWall) {
        EXPECT_FALSE(isClear);
      } else if (!isClear) {
        ++hidden;
      }
      clear += isClear ? 1 : 0;
    }
  }
  EXPECT_GT(clear, 100);
  EXPECT_LE(hidden, 3);  // corners that the steps jumped over
}

TEST(MazeFloor, wallLinesAreTheDrawing) {
  const DrawnMaze maze = smallMaze();
  const MazeFloor floor = maze.floor();
  std::vector<std::array<double, 4>> lines;
  for (const FloorLine& wall : floor.wallLines()) {
    lines.push_back({wall.from.x, wall.from.z, wall.to.x, wall.to.z});
  }
  EXPECT_EQ(lines.size(), 11u);
  EXPECT_THAT(lines, ::testing::Contains(std::array{2.0, 2.0, 4.0, 2.0}));
  for (const auto& [x0, z0, x1, z1] : lines) {
    EXPECT_TRUE(isInWall(maze, (x0 + x1) / 2, (z0 + z1) / 2)) << x0 << " " << z0;
    EXPECT_FALSE(floor.isClear({x0, z0}, {x1, z1}));
  }
}

}  // namespace
}  // namespace ocelli
