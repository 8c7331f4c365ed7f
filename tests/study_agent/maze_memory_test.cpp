#include "study/agent/maze_memory.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

FloorPatch way(const MazeCell& cell, Direction direction) {
  FloorPatch patch;
  patch.cell = cell;
  patch.way = direction;
  return patch;
}
FloorPatch ninth(const MazeCell& cell, int number) {
  FloorPatch patch;
  patch.cell = cell;
  patch.ninth = number;
  return patch;
}

TEST(MazeMemory, knowsWaysFromBothSides) {
  MazeMemory memory;
  memory.see(way({1, 1}, Direction::kEast), 5);
  memory.see(way({1, 1}, Direction::kSouth), 5);
  EXPECT_TRUE(memory.knowsWay({1, 1}, Direction::kEast));
  EXPECT_TRUE(memory.knowsWay({1, 2}, Direction::kWest));
  EXPECT_TRUE(memory.knowsWay({2, 1}, Direction::kNorth));
  EXPECT_FALSE(memory.knowsWay({1, 1}, Direction::kNorth));
}

TEST(MazeMemory, aWallThatWasFeltStaysOneForTheTrial) {
  MazeMemory memory;
  memory.see(way({1, 1}, Direction::kEast), 5);
  memory.feelWall({1, 2}, Direction::kWest);
  EXPECT_FALSE(memory.knowsWay({1, 1}, Direction::kEast));
  memory.see(way({1, 1}, Direction::kEast), 6);
  EXPECT_FALSE(memory.knowsWay({1, 1}, Direction::kEast));
  Random random(1);
  memory.beginTrial(0, random);
  memory.see(way({1, 1}, Direction::kEast), 7);
  EXPECT_TRUE(memory.knowsWay({1, 1}, Direction::kEast));
}

TEST(MazeMemory, infersWaysFromLinesOfSight) {
  MazeMemory memory;
  const SeenGrid grid{{0, 0}, 3, 1};
  memory.seeAlong(grid, {1.5, 1.5}, {8, 1.5});
  EXPECT_TRUE(memory.knowsWay({0, 0}, Direction::kEast));
  EXPECT_TRUE(memory.knowsWay({0, 1}, Direction::kEast));
  EXPECT_FALSE(memory.knowsWay({0, 2}, Direction::kEast));
  EXPECT_EQ(memory.waysKnown(), 2u);
}

TEST(MazeMemory, aCellIsSearchedOnceItsMiddleOrMostOfItWasSeen) {
  MazeMemory memory;
  memory.see(ninth({0, 0}, 4), 10);
  EXPECT_TRUE(memory.hasSearched({0, 0}, 0));
  EXPECT_TRUE(memory.hasSearched({0, 0}, 10));
  EXPECT_FALSE(memory.hasSearched({0, 0}, 11)) << "seen before that";
  for (const int number : {0, 1, 2, 3}) {
    memory.see(ninth({0, 1}, number), 10);
  }
  EXPECT_FALSE(memory.hasSearched({0, 1}, 0));
  memory.see(ninth({0, 1}, 5), 10);
  EXPECT_TRUE(memory.hasSearched({0, 1}, 0));
  EXPECT_FALSE(memory.hasSearched({3, 3}, 0));
}

TEST(MazeMemory, findsTheFastestWayAndCountsTurns) {
  // A ring of four cells: both ways around to the opposite corner take two cells, but one begins straight ahead.
  MazeMemory memory;
  memory.see(way({0, 0}, Direction::kEast), 0);
  memory.see(way({0, 0}, Direction::kSouth), 0);
  memory.see(way({0, 1}, Direction::kSouth), 0);
  memory.see(way({1, 0}, Direction::kEast), 0);
  const auto ways = memory.waysFrom({0, 0}, kPi / 2, 1, 0.5);  // looking east
  ASSERT_EQ(ways.size(), 4u);
  EXPECT_EQ(ways.at({1, 1}).cells, (std::vector<MazeCell>{{0, 1}, {1, 1}}));
  EXPECT_NEAR(ways.at({1, 1}).seconds, 2.5, 1e-12);
  EXPECT_NEAR(ways.at({0, 1}).seconds, 1, 1e-12);
  EXPECT_NEAR(ways.at({1, 0}).seconds, 1.5, 1e-12);
  EXPECT_TRUE(ways.at({0, 0}).cells.empty());
}

TEST(MazeMemory, forgetsSomeWaysBetweenTrialsAndAllThatWasSeen) {
  int kept = 0;
  int keptOften = 0;
  constexpr int kTimes = 400;
  for (int i = 0; i < kTimes; ++i) {
    Random random(static_cast<uint64_t>(i));
    MazeMemory memory;
    memory.see(way({0, 0}, Direction::kEast), 0);
    memory.see(ninth({0, 0}, 4), 0);
    for (int trial = 0; trial < 3; ++trial) {
      memory.beginTrial(0, random);
      memory.see(way({5, 5}, Direction::kEast), 0);
    }
    memory.beginTrial(0.5, random);
    kept += memory.knowsWay({0, 0}, Direction::kEast) ? 1 : 0;
    keptOften += memory.knowsWay({5, 5}, Direction::kEast) ? 1 : 0;
    EXPECT_FALSE(memory.hasSearched({0, 0}, 0));
  }
  // Half, and five sixths of those seen in three trials: four standard deviations.
  EXPECT_NEAR(kept, 200, 40);
  EXPECT_NEAR(keptOften, 333, 30);
}

}  // namespace
}  // namespace ocelli
