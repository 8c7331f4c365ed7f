#include "display_driver/device/ideal_device.h"

#include <gtest/gtest.h>

#include <atomic>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

/// A refresh takes 5 ms.
DisplayProfile fastProfile() {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = 3;
  profile.rotationsPerMinute = 6000;
  return profile;
}

class FullDisk final : public ShownFrames {
 public:
  void shown(const Volume&, HostTime) override { throw WorkError("no space", "the disk", "another one"); }
  void finish() override { ADD_FAILURE() << "there is nothing to finish"; }
};

TEST(IdealDeviceTest, aFailureEndsLaterFramesAndCloseThrowsIt) {
  IdealDevice device({.kind = "test", .name = {}, .serial = {}, .link = {}}, fastProfile(),
                     std::make_unique<FullDisk>());
  const Volume volume(fastProfile());
  FrameState state;
  while (state.stage != FrameStage::kLost) {
    const auto fence = device.submit(volume);
    device.present(fence->number(), {});
    state = fence->wait(FrameStage::kShown, 30s);
    ASSERT_TRUE(hasEnded(state.stage));
  }
  EXPECT_NE(state.problem.find("no space"), std::string::npos);
  const Telemetry telemetry = device.telemetry();
  EXPECT_FALSE(telemetry.connected);
  EXPECT_EQ(telemetry.lastProblem, state.problem);
  EXPECT_THROW(device.close(), WorkError);
}

/// Takes nothing before it is told to.
class SlowDisk final : public ShownFrames {
 public:
  explicit SlowDisk(std::atomic<bool>& go, std::atomic<int>& taken) : go_(go), taken_(taken) {}
  void shown(const Volume&, HostTime) override {
    go_.wait(false);
    ++taken_;
  }
  void finish() override {}

 private:
  std::atomic<bool>& go_;
  std::atomic<int>& taken_;
};

TEST(IdealDeviceTest, framesThatCannotBeTakenInTimeAreLostAndTheOthersAreNot) {
  std::atomic<bool> go = false;
  std::atomic<int> taken = 0;
  IdealDevice device({.kind = "test", .name = {}, .serial = {}, .link = {}}, fastProfile(),
                     std::make_unique<SlowDisk>(go, taken));
  const Volume volume(fastProfile());
  int shown = 0;
  int lost = 0;
  for (int i = 0; i < 10; ++i) {
    const auto fence = device.submit(volume);
    device.present(fence->number(), {});
    // Nobody but the callers moves frames on while the disk is busy.
    FrameState state = fence->state();
    while (!hasEnded(state.stage)) {
      device.telemetry();
      state = fence->wait(FrameStage::kShown, 1ms);
    }
    shown += state.stage == FrameStage::kShown ? 1 : 0;
    lost += state.stage == FrameStage::kLost ? 1 : 0;
  }
  EXPECT_EQ(shown, 4);
  EXPECT_EQ(lost, 6);
  go = true;
  go.notify_all();
  device.close();
  EXPECT_EQ(taken, 4);
}

}  // namespace
}  // namespace ocelli
