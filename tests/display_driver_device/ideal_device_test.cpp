#include "display_driver/device/ideal_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

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

const uint8_t* dataOf(const Volume& volume) {
  return volume.slice(0).data();
}

/// Where the bytes of the last volume lie.
class DataNoter final : public ShownFrames {
 public:
  explicit DataNoter(std::atomic<const uint8_t*>& data) : data_(data) {}
  void shown(const Volume& volume, HostTime) override { data_ = dataOf(volume); }
  void finish() override {}

 private:
  std::atomic<const uint8_t*>& data_;
};

TEST(IdealDeviceTest, volumesThatAreSharedOrGivenAwayAreNotCopied) {
  std::atomic<const uint8_t*> data = nullptr;
  IdealDevice device({.kind = "test", .name = {}, .serial = {}, .link = {}}, fastProfile(),
                     std::make_unique<DataNoter>(data));
  const auto show = [&](auto volume) {
    const auto fence = device.submit(std::move(volume));
    device.present(fence->number(), {});
    EXPECT_EQ(fence->wait(FrameStage::kShown, 30s).stage, FrameStage::kShown);
  };
  const auto waitFor = [&](const uint8_t* expected) {
    const auto end = std::chrono::steady_clock::now() + 30s;
    while (data != expected && std::chrono::steady_clock::now() < end) {
      device.telemetry();
      std::this_thread::sleep_for(1ms);
    }
    return data == expected;
  };
  const auto shared = std::make_shared<const Volume>(fastProfile());
  show(shared);
  EXPECT_TRUE(waitFor(dataOf(*shared)));
  Volume given(fastProfile());
  const uint8_t* givenData = dataOf(given);
  show(std::move(given));
  EXPECT_TRUE(waitFor(givenData));
  // As a part of it may have changed.
  const std::vector<int> changed = {1};
  Volume part(fastProfile());
  const uint8_t* partData = dataOf(part);
  device.present(device.submit(std::move(part), changed)->number(), {});
  EXPECT_TRUE(waitFor(partData));
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
