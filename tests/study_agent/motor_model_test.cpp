#include "study/agent/motor_model.h"

#include <gtest/gtest.h>

#include <map>

#include "study/task/floor_plan.h"
#include "study/task/walker.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr int64_t kHandSecond = 1'000'000'000;

class MotorModelTest : public testing::Test {
 protected:
  HumanFactors factors;
  Controls controls;
  MotorModel motor{factors, controls, 7};
};

const KeyEvent* keyOf(const TimedInput& input) {
  return std::get_if<KeyEvent>(&input.event);
}

TEST_F(MotorModelTest, HoldsAKeyForAboutAsLongAsPlannedAndRepeatsIt) {
  motor.plan(kHandSecond, {{controls.forward, kHandSecond, 3 * kHandSecond}});
  int64_t pressed = -1;
  int64_t released = -1;
  int repeats = 0;
  int64_t last = 0;
  for (const TimedInput& input : motor.take(5 * kHandSecond)) {
    EXPECT_GE(input.nanoseconds, last);
    last = input.nanoseconds;
    const KeyEvent* key = keyOf(input);
    ASSERT_NE(key, nullptr);
    EXPECT_EQ(key->key, controls.forward);
    if (!key->pressed) {
      released = input.nanoseconds;
    } else if (pressed < 0) {
      pressed = input.nanoseconds;
    } else {
      ++repeats;
    }
  }
  EXPECT_EQ(pressed, kHandSecond);
  // Five standard deviations.
  EXPECT_NEAR(static_cast<double>(released), 3e9, 5e9 * factors.keySpread);
  // 25 a second after half a second.
  EXPECT_NEAR(repeats, 37, 5);
  EXPECT_TRUE(motor.take(10 * kHandSecond).empty());
}

TEST_F(MotorModelTest, ANewPlanTakesThePlaceOfTheOldOne) {
  motor.plan(0, {{controls.forward, 0, 9 * kHandSecond}});
  EXPECT_EQ(motor.take(kHandSecond).size(), 1u + 13u);  // the key, and its repeats from half a second on
  motor.plan(2 * kHandSecond, {{controls.turnLeft, 2 * kHandSecond, 3 * kHandSecond}});
  std::map<Key, bool> held{{controls.forward, true}};
  for (const TimedInput& input : motor.take(10 * kHandSecond)) {
    held[keyOf(input)->key] = keyOf(input)->pressed;
    if (keyOf(input)->key == controls.forward && !keyOf(input)->pressed) {
      EXPECT_EQ(input.nanoseconds, 2 * kHandSecond);
    }
  }
  EXPECT_FALSE(held[controls.forward]);
  EXPECT_FALSE(held[controls.turnLeft]);
}

TEST_F(MotorModelTest, PointsFasterAtLargeAndNearThings) {
  motor.seePointer({0, 0});
  const double far = secondsOf(motor.point({600, 0}, 10, 0));
  motor.take(10 * kHandSecond);
  motor.seePointer({0, 0});
  const double near = secondsOf(motor.point({100, 0}, 10, 10 * kHandSecond)) - 10;
  motor.take(20 * kHandSecond);
  motor.seePointer({0, 0});
  const double large = secondsOf(motor.point({600, 0}, 100, 20 * kHandSecond)) - 20;
  // log2(61), log2(11) and log2(7) bits; each within the 40 % that a movement may differ, and a mouse's step.
  EXPECT_NEAR(far, 5.93 / factors.bitsPerSecond, 0.4 * 5.93 / factors.bitsPerSecond);
  EXPECT_NEAR(near, 3.46 / factors.bitsPerSecond, 0.4 * 3.46 / factors.bitsPerSecond + 0.02);
  EXPECT_LT(large, far);
  motor.take(30 * kHandSecond);
  EXPECT_NEAR(motor.pointer().x, 600, 100);
}

TEST_F(MotorModelTest, HitsWhatItPointsAtAlmostAlways) {
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    motor.seePointer({0, 0});
    motor.point({300, 200}, 20, i * 5 * kHandSecond);
    motor.take((i + 1) * 5 * kHandSecond);
    hits += std::abs(motor.pointer().x - 300) <= 10 && std::abs(motor.pointer().y - 200) <= 10 ? 1 : 0;
  }
  // Each coordinate misses by more than 4.133 standard deviations of 10 / 4.133 once in thousands.
  EXPECT_GE(hits, 495);
}

TEST_F(MotorModelTest, ReckonsWhereItsKeysAndMouseLead) {
  const Maze maze = test::studyMaze();
  const FloorPlan plan(maze, controls.bodyRadiusMeters);
  const WalkerPose start{1.5, 7.5, 1.5};
  Walker walker(plan, controls, start);
  motor.seePointer({320, 200});
  motor.pan(30, kHandSecond / 10);
  motor.plan(kHandSecond / 2,
             {{controls.forward, kHandSecond / 2, kHandSecond}, {controls.turnLeft, kHandSecond, 3 * kHandSecond / 2}});
  const WalkerPose expected = motor.reckon(start, 0, 2 * kHandSecond);
  const std::vector<TimedInput> inputs = motor.take(2 * kHandSecond);
  size_t next = 0;
  for (int64_t tick = 0; tick < 2 * kTicksPerSecond; ++tick) {
    for (; next < inputs.size() && inputs[next].nanoseconds * kTicksPerSecond / kHandSecond <= tick; ++next) {
      walker.handle(inputs[next].event);
    }
    walker.advance();
  }
  // A few ticks and steps of the reckoning: 1/60 s of each.
  EXPECT_NEAR(walker.pose().headingRadians, expected.headingRadians, 0.03);
  EXPECT_NEAR(walker.pose().x, expected.x, 0.06);
  EXPECT_NEAR(walker.pose().z, expected.z, 0.06);
  EXPECT_GT(std::abs(walker.pose().x - start.x), 1.0);
}

TEST_F(MotorModelTest, PansByAboutAsMuchAsMeant) {
  for (const double degrees : {-170.0, -40.0, 12.0, 90.0}) {
    MotorModel fresh(factors, controls, 3);
    const int64_t until = fresh.pan(degrees, 0);
    const WalkerPose turned = fresh.reckon({}, 0, until + 1);
    // Four standard deviations.
    EXPECT_NEAR(turned.headingRadians * 57.29578, degrees, 4 * 20 / 4.133);
    int pressed = 0;
    for (const TimedInput& input : fresh.take(until + kHandSecond)) {
      if (const auto* button = std::get_if<PointerButtonEvent>(&input.event)) {
        EXPECT_EQ(button->button, PointerButton::kRight);
        pressed += button->pressed ? 1 : -1;
      }
    }
    EXPECT_EQ(pressed, 0);
  }
}

TEST_F(MotorModelTest, RoundsCornersFromAsFarBeforeThemAsTheReach) {
  for (const double degrees : {-90.0, 50.0, 110.0}) {
    // Turning at the origin from north, on average over how exactly one turns.
    const double angle = degrees / 57.29578;
    double aside = 0;
    constexpr int kTurns = 400;
    for (int i = 0; i < kTurns; ++i) {
      MotorModel fresh(factors, controls, static_cast<uint64_t>(i));
      fresh.plan(0, {{controls.forward, 0, 9 * kHandSecond}});
      const int64_t until = fresh.pan(degrees, 0);
      const WalkerPose begin{0, fresh.panReach(degrees), 0};
      const WalkerPose end = fresh.reckon(begin, 0, until);
      aside += (end.x * std::cos(angle) + end.z * std::sin(angle)) / kTurns;  // of the way out of the corner
    }
    EXPECT_NEAR(aside, 0, 0.08 * motor.panReach(degrees)) << degrees;
  }
}

TEST_F(MotorModelTest, DropsTurnsYetToBeginForAnotherPlan) {
  motor.pan(90, kHandSecond);
  EXPECT_TRUE(motor.isPanning(kHandSecond + kHandSecond / 5));
  motor.plan(kHandSecond / 2, {{controls.forward, kHandSecond / 2, kHandSecond}});
  EXPECT_FALSE(motor.isPanning(kHandSecond + kHandSecond / 5));
  motor.pan(-90, kHandSecond);
  motor.plan(kHandSecond + kHandSecond / 10, {});
  EXPECT_TRUE(motor.isPanning(kHandSecond + kHandSecond / 5));  // it was under way
}

TEST_F(MotorModelTest, LetsGoOfEverything) {
  motor.plan(0, {{controls.forward, 0, 9 * kHandSecond}});
  motor.pan(90, kHandSecond);
  motor.take(kHandSecond + kHandSecond / 10);
  motor.release(kHandSecond + kHandSecond / 5);
  std::map<Key, bool> held;
  bool right = true;
  for (const TimedInput& input : motor.take(20 * kHandSecond)) {
    if (const KeyEvent* key = keyOf(input)) {
      held[key->key] = key->pressed;
    } else if (const auto* button = std::get_if<PointerButtonEvent>(&input.event)) {
      right = button->pressed;
    }
    EXPECT_LE(input.nanoseconds, kHandSecond + kHandSecond / 5);
  }
  EXPECT_FALSE(held[controls.forward]);
  EXPECT_FALSE(right);
}

}  // namespace
}  // namespace ocelli
