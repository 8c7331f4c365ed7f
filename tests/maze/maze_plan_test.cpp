#include "oc_core/maze/maze_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ocelli {
namespace {

using testing::ElementsAre;

/// A corridor of three cells along the north, and one way down from its western end.
MazePlan hook() {
  MazePlan plan(2, 3);
  plan.setOpen({0, 0}, Direction::kEast, true);
  plan.setOpen({0, 2}, Direction::kWest, true);
  plan.setOpen({1, 0}, Direction::kNorth, true);
  return plan;
}

TEST(MazePlan, passagesGoBothWays) {
  const MazePlan plan = hook();
  EXPECT_TRUE(plan.isOpen({0, 1}, Direction::kWest));
  EXPECT_TRUE(plan.isOpen({0, 1}, Direction::kEast));
  EXPECT_TRUE(plan.isOpen({0, 0}, Direction::kSouth));
  EXPECT_FALSE(plan.isOpen({0, 1}, Direction::kSouth));
  EXPECT_FALSE(plan.isOpen({0, 0}, Direction::kNorth));
  EXPECT_EQ(plan.kind({0, 0}), CellKind::kTurn);
  EXPECT_EQ(plan.kind({0, 1}), CellKind::kStraight);
  EXPECT_EQ(plan.kind({1, 1}), CellKind::kClosed);
  EXPECT_THAT(plan.ahead({0, 0}, Direction::kEast), ElementsAre(MazeCell{0, 1}, MazeCell{0, 2}));
}

TEST(MazePlan, shortestStepsAreThoseOfTheOnlyWay) {
  const MazePlan plan = hook();
  EXPECT_THAT(plan.shortestStepsFrom({1, 0}), ElementsAre(1, 2, 3, 0, std::nullopt, std::nullopt));
  EXPECT_EQ(plan.shortestSteps({0, 2}, {1, 0}), 3);
  EXPECT_EQ(plan.shortestSteps({1, 1}, {1, 1}), 0);
  EXPECT_EQ(plan.shortestSteps({0, 0}, {1, 2}), std::nullopt);
  EXPECT_EQ(plan.shortestSteps({0, 0}, {2, 0}), std::nullopt);
  EXPECT_EQ(plan.shortestSteps({0, -1}, {0, 0}), std::nullopt);
}

TEST(MazePlan, aLoopIsWalkedItsShorterWay) {
  MazePlan plan(1, 4);
  EXPECT_EQ(plan, MazePlan(1, 4));
  for (int column = 0; column < 3; ++column) {
    plan.setOpen({0, column}, Direction::kEast, true);
  }
  EXPECT_NE(plan, MazePlan(1, 4));
  MazePlan ring(2, 3);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      ring.setOpen({row, column}, Direction::kEast, true);
    }
  }
  ring.setOpen({0, 0}, Direction::kSouth, true);
  ring.setOpen({0, 2}, Direction::kSouth, true);
  EXPECT_THAT(ring.shortestStepsFrom({0, 1}), ElementsAre(1, 0, 1, 2, 3, 2));
  EXPECT_THAT(plan.shortestStepsFrom({0, 3}), ElementsAre(3, 2, 1, 0));
}

}  // namespace
}  // namespace ocelli
