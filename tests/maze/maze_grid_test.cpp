#include "oc_core/maze/maze_grid.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

// All numbers here are exact as doubles.
constexpr MazeGrid kGrid{2, 0.5, {10, 20}};

void expectSides(const FloorRectangle& rectangle, double west, double east, double north, double south) {
  EXPECT_EQ(rectangle.west, west);
  EXPECT_EQ(rectangle.east, east);
  EXPECT_EQ(rectangle.north, north);
  EXPECT_EQ(rectangle.south, south);
}

TEST(MazeGrid, pointsCountFromTheOrigin) {
  EXPECT_EQ(kGrid.corner({1, 3}), (FloorPoint{16, 22}));
  EXPECT_EQ(kGrid.corner({1, 3}, 1, 0), (FloorPoint{16, 24}));
  EXPECT_EQ(kGrid.corner({1, 3}, 0, 1), (FloorPoint{18, 22}));
  EXPECT_EQ(kGrid.pointOf({1, 3}), (FloorPoint{17, 23}));
  EXPECT_EQ(kGrid.pointOf({1, 3}, 0.25, -0.25), (FloorPoint{17.5, 22.5}));
}

TEST(MazeGrid, wallsReachOverTheirPosts) {
  expectSides(kGrid.postAt({16, 22}), 15.75, 16.25, 21.75, 22.25);
  expectSides(kGrid.wallOf({1, 3}, Direction::kNorth), 15.75, 18.25, 21.75, 22.25);
  expectSides(kGrid.wallOf({1, 3}, Direction::kSouth), 15.75, 18.25, 23.75, 24.25);
  expectSides(kGrid.wallOf({1, 3}, Direction::kWest), 15.75, 16.25, 21.75, 24.25);
  expectSides(kGrid.wallOf({1, 3}, Direction::kEast), 17.75, 18.25, 21.75, 24.25);
}

TEST(MazeGrid, aWallHasOneLineFromBothOfItsCells) {
  const FloorLine line = kGrid.lineOf({1, 3}, Direction::kEast);
  const FloorLine same = kGrid.lineOf({1, 4}, Direction::kWest);
  EXPECT_EQ(line.from, (FloorPoint{18, 22}));
  EXPECT_EQ(line.to, (FloorPoint{18, 24}));
  EXPECT_EQ(line.from, same.from);
  EXPECT_EQ(line.to, same.to);
}

TEST(FloorRectangle, meetsLinesThatTouchIt) {
  const FloorRectangle square{0, 1, 0, 1};
  EXPECT_TRUE(square.meets({{-1, 0.5}, {2, 0.5}}));
  EXPECT_TRUE(square.meets({{0.5, 0.5}, {0.5, 0.5}}));
  EXPECT_TRUE(square.meets({{-1, 1}, {2, 1}})) << "along a side";
  EXPECT_TRUE(square.meets({{0.5, 1.5}, {1.5, 0.5}})) << "a corner";
  EXPECT_FALSE(square.meets({{0.5, 1.75}, {1.5, 0.75}}));
  EXPECT_FALSE(square.meets({{-2, 0.5}, {-0.25, 0.5}})) << "it ends before";
  EXPECT_FALSE(square.meets({{2, 2}, {2, 2}}));
}

}  // namespace
}  // namespace ocelli
