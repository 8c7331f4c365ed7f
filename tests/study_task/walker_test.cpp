#include "study/task/walker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "study/task/task_pointer.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::press;
using test::release;

/// Rounding of 240 steps.
constexpr double kRounding = 1e-9;

/// In the middle of row 2, which runs from west to east over 18 m, looking east.
class WalkerTest : public testing::Test {
 protected:
  void goOn(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      walker_.advance();
    }
  }

  Maze maze_ = test::studyMaze();
  Controls controls_{};
  FloorPlan plan_{maze_, controls_.bodyRadiusMeters};
  Walker walker_{plan_, controls_, {4.5, 7.5, kPi / 2}};
};

TEST_F(WalkerTest, walksAsFastAsTheControlsSay) {
  walker_.handle(press(Key::kW));
  goOn(240);
  walker_.handle(release(Key::kW));
  goOn(100);
  EXPECT_NEAR(walker_.pose().x, 7.5, kRounding);
  EXPECT_NEAR(walker_.pose().z, 7.5, kRounding);
  EXPECT_NEAR(walker_.pathMeters(), 3, kRounding);
  EXPECT_EQ(walker_.collisions(), 0);
}

TEST_F(WalkerTest, keysOfTheArrowsWalkAndTurnToo) {
  walker_.handle(press(Key::kUp));
  goOn(120);
  walker_.handle(release(Key::kUp));
  walker_.handle(press(Key::kDown));
  goOn(40);
  walker_.handle(release(Key::kDown));
  EXPECT_NEAR(walker_.pose().x, 5.5, kRounding);
  walker_.handle(press(Key::kRight));
  goOn(240);
  EXPECT_NEAR(std::abs(walker_.pose().headingRadians), kPi, kRounding);  // to the south
  EXPECT_NEAR(walker_.turnedDegrees(), 90, kRounding);
}

TEST_F(WalkerTest, arrowsWithShiftAreThePointers) {
  TaskPointer pointer({0, 48, 640, 432}, controls_);
  for (const KeyEvent& event : {press(Key::kRight, true), press(Key::kUp, true)}) {
    walker_.handle(event);
    pointer.handle(event);
  }
  goOn(24);
  for (int i = 0; i < 24; ++i) {
    pointer.advance();
  }
  EXPECT_EQ(walker_.pose(), (WalkerPose{4.5, 7.5, kPi / 2}));
  EXPECT_NEAR(pointer.place().x, 320 + 60, kRounding);
  EXPECT_NEAR(pointer.place().y, 264 - 60, kRounding);
  // Released without Shift: it stops nevertheless.
  pointer.handle(release(Key::kRight));
  pointer.handle(release(Key::kUp));
  pointer.advance();
  EXPECT_NEAR(pointer.place().x, 380, kRounding);
}

TEST_F(WalkerTest, aslantIsNotFaster) {
  walker_.handle(press(Key::kW));
  walker_.handle(press(Key::kD));
  goOn(24);
  EXPECT_NEAR(walker_.pathMeters(), 0.3, kRounding);
  EXPECT_NEAR(walker_.pose().x - 4.5, 0.3 / std::sqrt(2.0), kRounding);
  EXPECT_NEAR(walker_.pose().z - 7.5, 0.3 / std::sqrt(2.0), kRounding);
}

TEST_F(WalkerTest, oppositeKeysCancel) {
  for (const Key key : {Key::kW, Key::kS, Key::kA, Key::kD, Key::kQ, Key::kE}) {
    walker_.handle(press(key));
  }
  goOn(50);
  EXPECT_EQ(walker_.pose(), (WalkerPose{4.5, 7.5, kPi / 2}));
}

TEST_F(WalkerTest, theRightButtonPans) {
  walker_.handle(test::moveTo({100, 50}));
  walker_.handle(test::moveTo({200, 50}));
  EXPECT_EQ(walker_.pose().headingRadians, kPi / 2);
  walker_.handle(test::button(PointerButton::kRight, true));
  walker_.handle(test::moveTo({300, 90}));
  walker_.handle(test::button(PointerButton::kRight, false));
  walker_.handle(test::moveTo({0, 0}));
  EXPECT_NEAR(degreesFromRadians(walker_.pose().headingRadians), 90 + 100 * controls_.mouseDegreesPerPixel, kRounding);
}

TEST_F(WalkerTest, wallsCountOnceAsLongAsOneGoesAlong) {
  // Row 0 has an unbroken wall in the north: to the north-west one comes to it, and along it into the corner.
  Walker walker(plan_, controls_, {10.5, 1.5, -kPi / 4});
  const auto goOnBy = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      walker.advance();
    }
  };
  walker.handle(press(Key::kW));
  goOnBy(2000);
  EXPECT_EQ(walker.collisions(), 1);
  EXPECT_NEAR(walker.pose().x, 0.15 + controls_.bodyRadiusMeters, 1e-6);
  EXPECT_NEAR(walker.pose().z, 0.15 + controls_.bodyRadiusMeters, 1e-6);
  walker.handle(release(Key::kW));
  goOnBy(1);
  walker.handle(press(Key::kW));
  goOnBy(10);
  EXPECT_EQ(walker.collisions(), 2);
}

TEST(TaskPointerTest, staysInItsArea) {
  const Controls controls;
  TaskPointer pointer({10, 50, 100, 100}, controls);
  EXPECT_EQ(pointer.place(), glm::dvec2(60, 100));
  pointer.handle(test::moveTo({-5, 1e9}));
  EXPECT_EQ(pointer.place(), glm::dvec2(10, 149));
  pointer.handle(test::moveTo({std::nan(""), 60}));
  EXPECT_EQ(pointer.place(), glm::dvec2(10, 60));
}

TEST(TaskPointerTest, clicksAreTheLeftButtonAndTheKey) {
  const Controls controls;
  TaskPointer pointer({0, 0, 100, 100}, controls);
  EXPECT_TRUE(pointer.isClick(test::button(PointerButton::kLeft, true)));
  EXPECT_FALSE(pointer.isClick(test::button(PointerButton::kLeft, false)));
  EXPECT_FALSE(pointer.isClick(test::button(PointerButton::kRight, true)));
  EXPECT_TRUE(pointer.isClick(press(Key::kSpace)));
  pointer.handle(press(Key::kSpace));
  EXPECT_FALSE(pointer.isClick(press(Key::kSpace)));  // a repeat
}

}  // namespace
}  // namespace ocelli
