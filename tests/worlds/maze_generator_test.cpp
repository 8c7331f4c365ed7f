#include "oc_core/worlds/maze_generator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_graph.h"
#include "oc_core/worlds/maze_validate.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

using test::mazeOptions;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Cells that can be reached from the entrance, by relabelling neighbours until nothing changes.
size_t reachable(const Maze& maze) {
  std::set<MazeCell> reached{maze.entrance.value().cell};
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < maze.rows(); ++row) {
      for (int column = 0; column < maze.columns(); ++column) {
        for (const Direction direction : kDirections) {
          const MazeCell cell{row, column};
          if (reached.contains(cell) && maze.isOpen(cell, direction)) {
            changed |= reached.insert(cell.neighbor(direction)).second;
          }
        }
      }
    }
  }
  return reached.size();
}

TEST(MazeGenerator, ReachesEveryCellOfManyMazes) {
  for (uint64_t seed = 0; seed < 250; ++seed) {
    const Maze maze = generateMaze(mazeOptions(seed));
    EXPECT_NO_THROW(validate(maze, "maze"));
    EXPECT_EQ(reachable(maze), static_cast<size_t>(maze.rows() * maze.columns())) << seed;
    EXPECT_EQ(maze.landmarks.size(), mazeOptions(seed).landmarks);
    std::set<MazeCell> cells;
    for (const Landmark& landmark : maze.landmarks) {
      EXPECT_TRUE(cells.insert(landmark.cell).second) << "two landmarks in a cell of maze " << seed;
    }
    const MazeGraph graph(maze);
    if (mazeOptions(seed).loops == 0) {
      EXPECT_EQ(graph.loops, 0u) << seed;
    }
    for (int row = 0; row + 1 < maze.rows(); ++row) {
      for (int column = 0; column + 1 < maze.columns(); ++column) {
        const bool openPost = maze.isOpen({row, column}, Direction::kEast) &&
                              maze.isOpen({row, column}, Direction::kSouth) &&
                              maze.isOpen({row + 1, column + 1}, Direction::kNorth) &&
                              maze.isOpen({row + 1, column + 1}, Direction::kWest);
        EXPECT_FALSE(openPost) << "a post without a wall in maze " << seed;
      }
    }
  }
}

TEST(MazeGenerator, FollowsTheSeed) {
  MazeOptions options;
  const std::string one = jsonText(generateMaze(options));
  EXPECT_EQ(jsonText(generateMaze(options)), one);
  options.seed = 2;
  EXPECT_NE(jsonText(generateMaze(options)), one);
  // Written down once, and the same on every platform since.
  options = {.seed = 3, .rows = 3, .columns = 4, .loops = 0.5, .landmarks = 0};
  for (const char* line : {R"("+-+-+-+-+")", R"("|       |")", R"("+ + +-+ +")", R"("| |     |")", R"("+ +-+ + +")",
                           R"("|     | |")", R"("+-+ +-+-+")"}) {
    EXPECT_THAT(jsonText(generateMaze(options)), HasSubstr(line));
  }
}

TEST(MazeGenerator, GivesTheLoopsThatAreAskedFor) {
  MazeOptions options{.seed = 5, .rows = 10, .columns = 10};
  // A spanning tree of 100 cells leaves 180 - 99 = 81 of the inner walls.
  for (const double share : {0.0, 0.1, 0.3}) {
    options.loops = share;
    EXPECT_EQ(MazeGraph(generateMaze(options)).loops, static_cast<size_t>(std::lround(81 * share)));
  }
}

TEST(MazeGenerator, GivesTheCrossingsThatAreAskedFor) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    const MazeOptions options{.seed = seed, .loops = 0, .minThreeWay = 8, .minFourWay = 3};
    const MazeGraph graph(generateMaze(options));
    EXPECT_GE(graph.count(CellKind::kThreeWay), 8u) << seed;
    EXPECT_GE(graph.count(CellKind::kFourWay), 3u) << seed;
  }
}

TEST(MazeGenerator, RefusesWhatCannotBe) {
  const auto generate = [](const MazeOptions& options) { return [options] { generateMaze(options); }; };
  EXPECT_THAT(generate({.rows = 0}), ThrowsMessage<InputError>(HasSubstr("out of range")));
  EXPECT_THAT(generate({.columns = 65}), ThrowsMessage<InputError>(HasSubstr("out of range")));
  EXPECT_THAT(generate({.rows = 1, .columns = 1, .landmarks = 0}), ThrowsMessage<InputError>(HasSubstr("one cell")));
  EXPECT_THAT(generate({.loops = -0.1}), ThrowsMessage<InputError>(HasSubstr("share")));
  EXPECT_THAT(generate({.loops = std::nan("")}), ThrowsMessage<InputError>(HasSubstr("share")));
  EXPECT_THAT(generate({.minFourWay = 26}), ThrowsMessage<InputError>(HasSubstr("26 crossings of 4 ways")));
  EXPECT_THAT(generate({.minThreeWay = 50}), ThrowsMessage<InputError>(HasSubstr("50 crossings of 3 ways")));
  EXPECT_THAT(generate({.landmarks = 50}), ThrowsMessage<InputError>(HasSubstr("50 landmarks")));
  EXPECT_NO_THROW(generateMaze({.rows = 64, .columns = 64, .loops = 1, .landmarks = 4096}));
}

}  // namespace
}  // namespace ocelli
