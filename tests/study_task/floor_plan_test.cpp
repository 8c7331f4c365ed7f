#include "study/task/floor_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/maze_generator.h"
#include "tests/study_task/maze_walks.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr double kRadius = 0.4;
/// By which the plan keeps away from walls, and the maze's lengths of 3 and 0.3 m are not exact as floats.
constexpr double kNear = 1e-6;

glm::dvec2 middle(const Maze& maze, int row, int column) {
  const glm::vec3 center = maze.centerOf({row, column});
  return {static_cast<double>(center.x), static_cast<double>(center.z)};
}

TEST(FloorPlan, clearanceIsTheDistanceToTheNearestWall) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, kRadius);
  // Row 2 runs from west to east; at column 1 there are ways to the north and to the south: the posts are nearest.
  EXPECT_NEAR(plan.clearance(middle(maze, 2, 0)), 1.35, kNear);
  EXPECT_NEAR(plan.clearance(middle(maze, 2, 2)), 1.35 * std::sqrt(2.0), kNear);
  EXPECT_NEAR(plan.clearance(middle(maze, 2, 0) + glm::dvec2(-1, 0)), 0.35, kNear);
  EXPECT_EQ(plan.clearance({-1, 5}), 0);
  EXPECT_EQ(plan.clearance({1e300, 5}), 0);
  EXPECT_EQ(plan.clearance({0, 0}), 0);
}

TEST(FloorPlan, oneStopsAtWallsAndSlidesAlongThem) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, kRadius);
  const glm::dvec2 from = middle(maze, 0, 2);  // a wall in the north
  const FloorPlan::Step ahead = plan.walk(from, {0, -2});
  EXPECT_TRUE(ahead.touched);
  EXPECT_NEAR(ahead.place.x, from.x, kNear);
  EXPECT_NEAR(ahead.place.y, 0.15 + kRadius, kNear);
  const FloorPlan::Step aslant = plan.walk(from, {2.5, -2});
  EXPECT_NEAR(aslant.place.x, from.x + 2.5, kNear);
  EXPECT_NEAR(aslant.place.y, 0.15 + kRadius, kNear);
  const FloorPlan::Step corner = plan.walk(middle(maze, 0, 0), {-3, -3});
  EXPECT_NEAR(corner.place.x, 0.15 + kRadius, kNear);
  EXPECT_NEAR(corner.place.y, 0.15 + kRadius, kNear);
  const FloorPlan::Step free = plan.walk(from, {1, 0.5});
  EXPECT_FALSE(free.touched);
  EXPECT_NEAR(free.place.x, from.x + 1, kNear);
  EXPECT_NEAR(free.place.y, from.y + 0.5, kNear);
}

TEST(FloorPlan, postsAreRound) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, kRadius);
  // The cell in row 2, column 2 has ways to all sides, and its posts stand alone at its corners.
  const glm::dvec2 from = middle(maze, 2, 2);
  const FloorPlan::Step straight = plan.walk(from, {-1.5, -1.5});
  EXPECT_TRUE(straight.touched);
  EXPECT_NEAR(plan.clearance(straight.place), kRadius, kNear);
  // From a little beside it one slides around the post into the way to the north.
  const FloorPlan::Step around = plan.walk(from + glm::dvec2(-0.7, 0), {-0.4, -3});
  EXPECT_LT(around.place.y, from.y - 1.5);
  EXPECT_GE(plan.clearance(around.place), kRadius);
}

TEST(FloorPlan, longStepsDoNotPassThroughWalls) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, kRadius);
  const FloorPlan::Step step = plan.walk(middle(maze, 0, 2), {0, -100});
  EXPECT_NEAR(step.place.y, 0.15 + kRadius, kNear);
  EXPECT_EQ(plan.walk(middle(maze, 0, 2), {0, 0}).place, middle(maze, 0, 2));
}

TEST(FloorPlan, theEntranceIsClosed) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, kRadius);
  ASSERT_EQ(maze.entrance->cell, (MazeCell{4, 3}));
  const FloorPlan::Step out = plan.walk(middle(maze, 4, 3), {0, 5});
  EXPECT_NEAR(out.place.y, 15 - 0.15 - kRadius, kNear);
}

TEST(FloorPlan, randomWalksStayClear) {
  test::checkRandomWalks(20, 2000);
}

}  // namespace
}  // namespace ocelli
