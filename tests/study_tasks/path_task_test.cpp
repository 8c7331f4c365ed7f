#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "oc_core/base/conventions.h"
#include "study/task/floor_plan.h"
#include "study/task/maze_path.h"
#include "tests/study_task/study_tasks.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

constexpr TrialScreen kPathScreen{800, 600, 60};
constexpr PathWalk::Speed kSpeed{1.5, 90};

Direction turned(Direction heading, char turn) {
  return turn == 'L' ? leftOf(heading) : rightOf(heading);
}

/// Cells from the first to the last; empty where the path leads through a wall.
std::vector<MazeCell> cellsOf(const MazePath& path, const Maze& maze) {
  std::vector<MazeCell> cells{path.start};
  Direction heading = path.heading;
  for (size_t leg = 0; leg < path.legs.size(); ++leg) {
    for (int step = 0; step < path.legs[leg]; ++step) {
      if (!maze.isOpen(cells.back(), heading)) {
        return {};
      }
      cells.push_back(cells.back().neighbor(heading));
    }
    heading = leg < path.turns.size() ? turned(heading, path.turns[leg]) : heading;
  }
  return cells;
}

TEST(MazePath, theMapOfAPathStartsUp) {
  const Maze maze = test::studyMaze();
  const MazePath path{{2, 0}, Direction::kEast, {2, 1, 3}, "RL"};
  // Two steps ahead, one to the right, three ahead again, of 3 m each; up is -y.
  EXPECT_EQ(mapOf(path, maze), (std::vector<glm::dvec2>{{0, 0}, {0, -6}, {3, -6}, {3, -15}}));
}

TEST(MazePath, playbackLastsAsLongAsItsWay) {
  const Maze maze = test::studyMaze();
  // 4 steps of 3 m; each turn takes half a cell before and after it away, and goes a quarter of a circle of 1.5 m.
  const double turn = kPi / 2 * 1.5 / 1.5;
  EXPECT_NEAR(PathWalk::secondsOf(4, 2, maze, kSpeed), (4 - 2) * 3 / 1.5 + 2 * turn, 1e-9);
  // One cannot turn faster than 90 degrees a second.
  EXPECT_NEAR(PathWalk::secondsOf(4, 2, maze, {6, 90}), (4 - 2) * 3 / 6.0 + 2 * 1.0, 1e-9);
  const MazePath path{{2, 1}, Direction::kEast, {1, 2, 1}, "LR"};
  const PathWalk walk(path, maze, kSpeed);
  EXPECT_NEAR(walk.seconds(), PathWalk::secondsOf(4, 2, maze, kSpeed), 1e-9);
  EXPECT_EQ(walk.at(0), (WalkerPose{4.5, 7.5, kPi / 2}));
  const WalkerPose last = walk.at(walk.seconds());
  EXPECT_NEAR(last.x, 10.5, 1e-9);
  EXPECT_NEAR(last.z, 1.5, 1e-9);
  EXPECT_NEAR(last.headingRadians, kPi / 2, 1e-9);
  EXPECT_EQ(walk.at(1e9), last);
}

TEST(MazePath, randomPathsAreOnesThatOneCanWalk) {
  size_t tried = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    const FloorPlan plan(maze, 0.4);
    const MazePaths paths(maze, 8, 16);
    Random random(seed);
    for (const std::string& turns : paths.sequences(4)) {
      const auto path = paths.random(turns, random);
      ASSERT_TRUE(path.has_value());
      EXPECT_EQ(path->turns, turns);
      const std::vector<MazeCell> cells = cellsOf(*path, maze);
      EXPECT_GE(cells.size(), 9u);
      EXPECT_LE(cells.size(), 17u);
      EXPECT_GE(*std::min_element(path->legs.begin(), path->legs.end()), 1);
      // Smooth, and clear of walls.
      const PathWalk walk(*path, maze, kSpeed);
      WalkerPose before = walk.at(0);
      for (int tick = 1; tick < walk.seconds() * 240; ++tick) {
        const WalkerPose now = walk.at(tick / 240.0);
        EXPECT_LE(std::hypot(now.x - before.x, now.z - before.z), 1.5 / 240 + 1e-9);
        EXPECT_LE(std::abs(std::remainder(now.headingRadians - before.headingRadians, 2 * kPi)),
                  radiansFromDegrees(90) / 240 + 1e-9);
        ASSERT_GE(plan.clearance({now.x, now.z}), 0.4);
        before = now;
      }
      ++tried;
    }
  }
  EXPECT_GT(tried, 50u);
}

TEST(MazePath, allPathsOfASequenceAreEquallyLikely) {
  const Maze maze = test::studyMaze();
  const MazePaths paths(maze, 5, 6);
  // All of them, by hand: every start, heading and split of the steps, that comes into no cell twice.
  std::set<std::string> all;
  const auto nameOfPath = [](const std::vector<MazeCell>& cells) {
    std::string name;
    for (const MazeCell& cell : cells) {
      name += nameOf(cell);
    }
    return name;
  };
  for (int steps = 5; steps <= 6; ++steps) {
    for (int first = 1; first < steps - 1; ++first) {
      for (int second = 1; first + second < steps; ++second) {
        for (int row = 0; row < maze.rows(); ++row) {
          for (int column = 0; column < maze.columns(); ++column) {
            for (const Direction heading : kDirections) {
              const std::vector<MazeCell> cells =
                  cellsOf({{row, column}, heading, {first, second, steps - first - second}, "LR"}, maze);
              if (std::set<MazeCell>(cells.begin(), cells.end()).size() == static_cast<size_t>(steps) + 1) {
                all.insert(nameOfPath(cells));
              }
            }
          }
        }
      }
    }
  }
  ASSERT_GT(all.size(), 5u);
  std::map<std::string, int> drawn;
  Random random(8);
  constexpr int kDraws = 2000;
  for (int i = 0; i < kDraws; ++i) {
    ++drawn[nameOfPath(cellsOf(*paths.random("LR", random), maze))];
  }
  EXPECT_EQ(drawn.size(), all.size());
  const double expected = static_cast<double>(kDraws) / static_cast<double>(all.size());
  for (const auto& [name, count] : drawn) {
    EXPECT_TRUE(all.contains(name));
    EXPECT_NEAR(count, expected, 5 * std::sqrt(expected));  // five standard deviations of a Poisson number
  }
}

TEST(PathTask, offersTheRightMapAmongOthersOfTheSameMaze) {
  const test::TaskExample& example = test::taskExample("path");
  const auto block = test::readBlock("path", example.json);
  std::map<int, int> places;
  for (uint64_t seed = 1; seed <= 120; ++seed) {
    const TrialPlan plan = test::planOf("path", 0, TrialView::kReference, seed);
    const auto run = block->start(plan, kPathScreen);
    EXPECT_TRUE(run->layout().maps.empty());
    // The turns of the walk, from its headings.
    std::vector<WalkerPose> poses;
    int64_t ticks = 0;
    while (run->layout().maps.empty()) {
      poses.push_back(run->pose());
      run->handle(test::press(Key::k1));  // too early
      run->advance();
      ++ticks;
    }
    EXPECT_GE(ticks, 4 * 240);
    EXPECT_LE(ticks, 7 * 240);
    double heading = 0;
    std::string turns;
    for (size_t i = 1; i < poses.size(); ++i) {
      heading += std::remainder(poses[i].headingRadians - poses[i - 1].headingRadians, 2 * kPi);
      if (std::abs(heading) > kPi / 2 * 0.99) {
        turns += heading < 0 ? 'L' : 'R';
        heading -= heading < 0 ? -kPi / 2 : kPi / 2;
      }
    }
    EXPECT_EQ(turns, block->answerOf(plan));
    const TrialLayout layout = run->layout();
    ASSERT_EQ(layout.maps.size(), 3u);
    ASSERT_EQ(layout.choices.size(), 3u);
    std::set<std::string> sequences;
    int right = -1;
    for (size_t i = 0; i < 3; ++i) {
      const std::vector<glm::dvec2>& corners = layout.maps[i].corners;
      ASSERT_EQ(corners.size(), 5u);
      EXPECT_LT(corners[1].y, 0);
      EXPECT_EQ(corners[1].x, 0);
      std::string sequence;
      for (size_t k = 1; k + 1 < corners.size(); ++k) {
        const glm::dvec2 in = corners[k] - corners[k - 1];
        const glm::dvec2 out = corners[k + 1] - corners[k];
        sequence += in.x * out.y - in.y * out.x > 0 ? 'R' : 'L';
      }
      sequences.insert(sequence);
      right = sequence == turns ? static_cast<int>(i) : right;
    }
    EXPECT_EQ(sequences.size(), 3u);
    ASSERT_GE(right, 0);
    ++places[right];
    run->handle(test::press(static_cast<Key>(static_cast<int>(Key::k1) + right)));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_TRUE(run->outcome()->correct);
    EXPECT_EQ(run->outcome()->answer, turns);
    EXPECT_EQ(run->outcome()->responseTicks, 0);
  }
  for (int place = 0; place < 3; ++place) {
    EXPECT_GT(places[place], 20);  // of 120; 40 on average, with a standard deviation of 5.2
  }
}

TEST(PathTask, saysWhatCannotBe) {
  const auto expect = [](const std::string& fields, const std::string& part) {
    const std::string text = test::readError("path", R"({"maze": "small", "cases": [{"label": "a"}], )" + fields + "}");
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  // 3 m/s, as controls say: five turns within 90 m do not fit into this maze.
  expect(R"("least_seconds": 30, "most_seconds": 40)", "meters_per_second");
  expect(R"("least_seconds": 30, "most_seconds": 29)", "most_seconds");
  expect(R"("turns": 6, "least_seconds": 1, "most_seconds": 2)", "shortest lasts");
  expect(R"("turns": 7)", "turns");
  expect(R"("maps": 1)", "maps");
  expect(R"("cases": 3)", "");
}

}  // namespace
}  // namespace ocelli
