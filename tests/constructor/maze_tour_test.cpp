#include "oc_core/constructor/maze_tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/constructor/maze_plans.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::vector<TourLeg> fromEntrance(const Maze& maze, TourOrder order = TourOrder::kBreadthFirst) {
  return tourOf(maze, maze.entrance->cell, maze.entrance->heading, order);
}

TEST(MazeTour, goesStraightToTheCrossingAndBranchesThere) {
  const Maze maze = test::mazeOfPlan({"+-+-+-+", "| | | |", "+ + + +", "| | | |", "+ + + +", "|     |", "+-+ +-+"});
  const std::vector<TourLeg> legs = fromEntrance(maze);
  ASSERT_EQ(legs.size(), 6u);
  EXPECT_EQ(legs[0].cells, (std::vector<MazeCell>{{2, 1}}));
  EXPECT_EQ(legs[0].children, (std::vector<int>{1, 2, 3}));  // left, ahead, right
  EXPECT_EQ(legs[1].heading, Direction::kWest);
  EXPECT_EQ(legs[2].cells, (std::vector<MazeCell>{{1, 1}, {0, 1}}));
  EXPECT_EQ(legs[3].heading, Direction::kEast);
  EXPECT_EQ(legs[0].cellsAfter, 8u);
  EXPECT_EQ(legs[1].cellsAfter, 2u);
  EXPECT_EQ(legs[2].cellsAfter, 0u);
}

TEST(MazeTour, hasEachCellOnceInAnyMaze) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    for (const TourOrder order : {TourOrder::kBreadthFirst, TourOrder::kDepthFirst}) {
      std::set<MazeCell> cells;
      const std::vector<TourLeg> legs = fromEntrance(maze, order);
      for (const TourLeg& leg : legs) {
        for (size_t i = 0; i < leg.cells.size(); ++i) {
          EXPECT_TRUE(cells.insert(leg.cells[i]).second) << nameOf(leg.cells[i]) << " of seed " << seed;
          const MazeCell before = i > 0             ? leg.cells[i - 1]
                                  : leg.parent >= 0 ? legs[static_cast<size_t>(leg.parent)].cells.back()
                                                    : leg.cells[0].neighbor(opposite(leg.heading));
          EXPECT_EQ(before.neighbor(leg.heading), leg.cells[i]);
          EXPECT_TRUE(!maze.contains(before) || maze.isOpen(before, leg.heading));
        }
        for (const int child : leg.children) {
          EXPECT_NE(legs[static_cast<size_t>(child)].heading, opposite(leg.heading));
        }
        // A leg that only goes on ahead would be one with its child.
        EXPECT_FALSE(leg.children.size() == 1 && legs[static_cast<size_t>(leg.children[0])].heading == leg.heading);
      }
      EXPECT_EQ(cells.size(), maze.cellCount()) << "seed " << seed;
      EXPECT_EQ(legs[0].cells.size() + legs[0].cellsAfter, maze.cellCount());
    }
  }
}

TEST(MazeTour, breadthFirstMeetsHalfwayAndDepthFirstGoesAround) {
  // A ring: from the entrance to both sides.
  const Maze ring = test::mazeOfPlan({"+-+-+-+", "|     |", "+ +-+ +", "| | | |", "+ + + +", "|     |", "+-+ +-+"});
  const std::vector<TourLeg> breadth = fromEntrance(ring);
  const std::vector<TourLeg> depth = fromEntrance(ring, TourOrder::kDepthFirst);
  EXPECT_EQ(breadth[0].children.size(), 3u);
  // Depth first, the way to the left takes all of the ring; what is ahead is a dead end.
  ASSERT_FALSE(depth[0].children.empty());
  EXPECT_EQ(depth[1].heading, Direction::kWest);
  EXPECT_EQ(depth[1].cells.size() + depth[1].cellsAfter, 7u);
}

TEST(MazeTour, tellsOfACellThatIsNotThere) {
  const Maze maze(2, 3);
  EXPECT_THAT(test::inputErrorOf([&] {
                tourOf(maze, {2, 0}, Direction::kNorth, TourOrder::kBreadthFirst);
              }),
              HasSubstr("(row 2, column 0) is not in the maze"));
}

}  // namespace
}  // namespace ocelli
