#include "study/responses/response_input.h"

#include <gtest/gtest.h>

#include "tests/study_responses/pseudo_box.h"

namespace ocelli::test {
namespace {

/// Tells what it was given.
class GivenDevice : public ResponseDevice {
 public:
  explicit GivenDevice(bool polls = false) : polls_(polls) {}
  std::vector<KeyChange> take() override { return std::exchange(changes, {}); }
  void poll() override { ++polled; }
  bool mustBePolled() const override { return polls_; }
  bool isConnected() const override { return connected; }
  ResponseCounts counts() const override { return {7, 1}; }
  std::string description() const override { return "given"; }

  std::vector<KeyChange> changes{};
  bool connected = true;
  int polled = 0;

 private:
  bool polls_;
};

struct Given {
  explicit Given(double debounce = 10, bool polls = false) {
    std::vector<std::unique_ptr<ResponseDevice>> devices;
    devices.push_back(std::make_unique<GivenDevice>(polls));
    device = static_cast<GivenDevice*>(devices.front().get());
    input = std::make_unique<ResponseInput>(std::move(devices), debounce);
  }
  GivenDevice* device = nullptr;
  std::unique_ptr<ResponseInput> input;
};

TEST(ResponseInput, DebouncesDevicesAndTheKeyboardByThemselves) {
  const Given given;
  given.device->changes = {{Key::k1, true, 0}, {Key::k1, false, kMillisecond}, {Key::k1, true, 2 * kMillisecond}};
  EXPECT_EQ(textOf(given.input->take(3 * kMillisecond)), "+1");
  EXPECT_EQ(textOf(given.input->takeKey({Key::k1, true, 4 * kMillisecond})), "+1") << "another key of the same name";
  EXPECT_EQ(textOf(given.input->takeKey({Key::k1, false, 5 * kMillisecond})), "");
  EXPECT_EQ(textOf(given.input->take(20 * kMillisecond)), "-1") << "of the keyboard, which was held back";
  const std::vector<ResponseState> states = given.input->states();
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].bounces, 0);
  EXPECT_EQ(states[1].bounces, 1);
  EXPECT_EQ(states[1].counts.presses, 7);
}

TEST(ResponseInput, IsInOrderOfTime) {
  const Given given;
  given.input->takeKey({Key::k1, true, 0});
  given.input->takeKey({Key::k1, false, 9 * kMillisecond});
  given.device->changes = {{Key::k2, true, 5 * kMillisecond}, {Key::k3, true, 12 * kMillisecond}};
  EXPECT_EQ(textOf(given.input->take(20 * kMillisecond)), "+2 -1 +3");
}

TEST(ResponseInput, TellsOnceThatADeviceIsGone) {
  const Given given;
  EXPECT_TRUE(given.input->lost().empty());
  given.device->connected = false;
  EXPECT_EQ(given.input->lost(), std::vector<std::string>{"given"});
  EXPECT_TRUE(given.input->lost().empty());
}

TEST(ResponseInput, PollsWhatMustBePolled) {
  EXPECT_FALSE(Given().input->mustBePolled());
  const Given polled(10, true);
  EXPECT_TRUE(polled.input->mustBePolled());
  polled.input->poll();
  EXPECT_EQ(polled.device->polled, 1);
}

TEST(ResponseInput, LetsAllPassWithoutDebouncing) {
  const Given given(0);
  given.device->changes = {{Key::k1, true, 0}, {Key::k1, false, 1}, {Key::k1, true, 2}};
  EXPECT_EQ(textOf(given.input->take(3)), "+1 -1 +1");
}

}  // namespace
}  // namespace ocelli::test
