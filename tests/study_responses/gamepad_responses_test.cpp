#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/study_responses/pseudo_box.h"

namespace ocelli::test {
namespace {

class GamepadTest : public testing::Test {
 protected:
  std::unique_ptr<ResponseDevice> open(const std::string& map = "") {
    return openResponseDevice("gamepad" + (map.empty() ? "" : ":" + map), {[this] { return state_; }});
  }
  static std::string look(ResponseDevice& device) {
    device.poll();
    return textOf(device.take());
  }

  std::optional<GamepadState> state_ = GamepadState{"Pad"};
};

TEST_F(GamepadTest, TakesButtonsForKeys) {
  const auto device = open();
  EXPECT_TRUE(device->mustBePolled());
  EXPECT_EQ(look(*device), "");
  state_->buttons[0] = true;
  state_->buttons[14] = true;
  EXPECT_EQ(look(*device), "+Space +Left");
  EXPECT_EQ(look(*device), "") << "held";
  state_->buttons[0] = false;
  EXPECT_EQ(look(*device), "-Space");
  EXPECT_EQ(device->counts().presses, 2);
  EXPECT_EQ(device->description(), "gamepad: Pad");
}

TEST_F(GamepadTest, TakesTheStickForArrowsAndDoesNotTremble) {
  const auto device = open();
  state_->axes[0] = 0.45F;
  EXPECT_EQ(look(*device), "");
  state_->axes[0] = 0.6F;
  EXPECT_EQ(look(*device), "+Right");
  state_->axes[0] = 0.4F;
  EXPECT_EQ(look(*device), "") << "between the two limits";
  state_->axes[0] = -0.9F;
  EXPECT_EQ(look(*device), "-Right +Left");
  state_->axes[0] = 0;
  EXPECT_EQ(look(*device), "-Left");
}

TEST_F(GamepadTest, HoldsAKeyAsLongAsOneOfItsPartsIsDown) {
  const auto device = open();
  state_->buttons[12] = true;
  state_->axes[0] = 1;
  EXPECT_EQ(look(*device), "+Right");
  state_->buttons[12] = false;
  EXPECT_EQ(look(*device), "");
  state_->axes[0] = 0;
  EXPECT_EQ(look(*device), "-Right");
}

TEST_F(GamepadTest, FollowsAMap) {
  const auto device = open("West=1,LeftTrigger=2");
  state_->buttons[2] = true;
  state_->axes[4] = 0.9F;
  state_->buttons[0] = true;
  EXPECT_EQ(look(*device), "+1 +2");
  EXPECT_EQ(device->counts().unknown, 1) << "South";
}

TEST_F(GamepadTest, ReleasesAllWhenItGoes) {
  const auto device = open();
  state_->buttons[0] = true;
  look(*device);
  state_.reset();
  EXPECT_EQ(look(*device), "-Space");
  EXPECT_FALSE(device->isConnected());
}

TEST_F(GamepadTest, SaysWhatIsWrong) {
  EXPECT_THROW(open("Sauth=1"), InputError);
  EXPECT_THROW(open("South=-1"), InputError);
  state_.reset();
  EXPECT_THROW(open(), WorkError);
  EXPECT_THROW(openResponseDevice("gamepad", {}), WorkError);
}

}  // namespace
}  // namespace ocelli::test
