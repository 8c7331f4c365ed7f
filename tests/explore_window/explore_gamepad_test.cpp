#include "oc_core/explore_window/explore_gamepad.h"

#include <gtest/gtest.h>

#include <string_view>

namespace ocelli {
namespace {

TEST(ExploreGamepad, sticksMoveBeyondWhereTheyRest) {
  ExploreGamepad pad;
  GamepadState state;
  state.axes[0] = 0.1f;  // they tremble
  EXPECT_FALSE(pad.read(state).isUsed);
  state.axes = {1, -1, 0.59f, 0, -1, -1};
  const ExploreGamepad::Reading reading = pad.read(state);
  EXPECT_TRUE(reading.isUsed);
  EXPECT_FLOAT_EQ(reading.motion.right, 1);
  EXPECT_FLOAT_EQ(reading.motion.ahead, 1);         // up is negative
  EXPECT_FLOAT_EQ(reading.motion.turnRight, 0.5f);  // (0.59 - 0.18) / (1 - 0.18)
}

TEST(ExploreGamepad, aPressCountsOnceUntilItIsReleased) {
  ExploreGamepad pad;
  GamepadState state;
  state.buttons[7] = true;
  ASSERT_EQ(pad.read(state).pressed.size(), 1U);
  EXPECT_TRUE(pad.read(state).pressed.empty());
  state.buttons[7] = false;
  EXPECT_TRUE(pad.read(state).pressed.empty());
  state.buttons[7] = true;
  const ExploreGamepad::Reading again = pad.read(state);
  ASSERT_EQ(again.pressed.size(), 1U);
  EXPECT_EQ(std::string_view(again.pressed.front()->pad), "Start");
}

TEST(ExploreGamepad, oneThatIsUnpluggedHoldsNothing) {
  ExploreGamepad pad;
  GamepadState state;
  state.buttons[7] = true;
  state.axes[1] = -1;
  pad.read(state);
  EXPECT_FALSE(pad.read(std::nullopt).isUsed);
  EXPECT_EQ(pad.read(state).pressed.size(), 1U);
}

}  // namespace
}  // namespace ocelli
