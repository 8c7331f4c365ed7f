#include "analysis/measures/walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ocelli::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Walk, tellsOfASquare) {
  // A second along each of two sides of 3 m, half a second of turning right between them, half a second of rest.
  std::vector<Pose> poses;
  for (int i = 0; i <= 60; ++i) {
    poses.push_back({4 * i, 0, -3 * i / 60.0, 0});
  }
  for (int i = 1; i <= 30; ++i) {
    poses.push_back({240 + 4 * i, 0, -3, kPi / 2 * i / 30});
  }
  for (int i = 1; i <= 60; ++i) {
    poses.push_back({360 + 4 * i, 3 * i / 60.0, -3, kPi / 2});
  }
  for (int i = 1; i <= 30; ++i) {
    poses.push_back({600 + 4 * i, 3, -3, kPi / 2});
  }
  const auto walk = measureWalk(poses);
  ASSERT_TRUE(walk);
  EXPECT_NEAR(walk->seconds, 3, 1e-12);
  EXPECT_NEAR(walk->pathMeters, 6, 1e-12);
  EXPECT_NEAR(walk->turnedRadians, kPi / 2, 1e-12);
  EXPECT_NEAR(walk->standing, 1.0 / 3, 1e-12);
  EXPECT_NEAR(walk->turning, 0.5 / 3, 1e-12);
  EXPECT_NEAR(walk->still, 0.5 / 3, 1e-12);
}

TEST(Walk, turnsTheShorterWayOverNorth) {
  const std::vector<Pose> poses{{0, 0, 0, 0.1}, {4, 0, 0, 2 * kPi - 0.1}, {8, 0, 0, -0.2}};
  EXPECT_NEAR(measureWalk(poses)->turnedRadians, 0.3, 1e-12);
}

TEST(Walk, oneFrameTellsNothing) {
  const std::vector<Pose> poses{{0, 1, 1, 0}};
  EXPECT_FALSE(measureWalk(poses));
  EXPECT_FALSE(measureWalk({}));
  const std::vector<Pose> atOnce{{4, 1, 1, 0}, {4, 2, 1, 0}};
  EXPECT_FALSE(measureWalk(atOnce));
}

struct Sight : ::testing::Test {
  // One row of four cells, a wall between the third and the fourth.
  MazeFloor floor{readAnyDrawing({"+-+-+-+-+", "|     | |", "+-+-+-+-+"}), {2, 0.2}};
  TargetObject object{floor.grid().pointOf({0, 2}), 0.26};
};

TEST_F(Sight, needsTheFieldOfView) {
  EXPECT_TRUE(isInSight(floor, {0, 1, 1, kPi / 2}, object, 60));
  EXPECT_FALSE(isInSight(floor, {0, 1, 1, -kPi / 2}, object, 60));
  EXPECT_TRUE(isInSight(floor, {0, 1, 1, kPi / 2 + 2 * kPi + 0.5}, object, 60));  // 28.6 degrees off
  EXPECT_FALSE(isInSight(floor, {0, 1, 1, kPi / 2 + 0.65}, object, 60));  // 37.2, and the object's side 3 nearer
}

TEST_F(Sight, wallsHide) {
  const TargetObject behind{floor.grid().pointOf({0, 3}), 0.26};
  EXPECT_FALSE(isInSight(floor, {0, 1, 1, kPi / 2}, behind, 60));
}

TEST_F(Sight, aSideIsEnough) {
  // A wall hides the middle, not the right side: seen from the west, south of the object's middle.
  const MazeFloor corner(readAnyDrawing({"+-+-+", "|   |", "+-+ +", "|   |", "+-+-+"}), {2, 0.2});
  const TargetObject hidden{{3, 3}, 0.3};
  const Pose pose{0, 1, 1, kPi * 3 / 4};
  ASSERT_FALSE(corner.isClear({pose.x, pose.z}, hidden.place));
  EXPECT_FALSE(isInSight(corner, pose, hidden, 90));
  const TargetObject wide{{3, 3}, 1.25};
  EXPECT_TRUE(isInSight(corner, pose, wide, 90));
}

TEST_F(Sight, firstIsTheFirst) {
  const std::vector<Pose> poses{{0, 1, 1, 0}, {4, 1, 1, 0}, {8, 1, 1, 1.4}, {12, 1, 1, 1.5}};
  EXPECT_EQ(firstInSight(floor, poses, object, 60), 8 / 240.0);
  EXPECT_FALSE(firstInSight(floor, std::vector<Pose>{{0, 1, 1, 0}}, object, 60));
}

}  // namespace
}  // namespace ocelli::test
