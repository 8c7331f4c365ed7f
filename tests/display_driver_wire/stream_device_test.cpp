#include "display_driver/wire/stream_device.h"

#include <gtest/gtest.h>

#include <thread>

#include "display_driver/firmware/memory_bus.h"
#include "oc_core/base/error.h"
#include "tests/display_driver_wire/arrival_check.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

/// Longer than anything here takes: a test that waits for it has failed.
constexpr auto kLong = 10s;

/// A display that refreshes every 4 ms, behind a link with these faults.
EmulatedDeviceOptions quickDisplay(FaultScript faults = {}, double bytesPerSecond = 0) {
  DisplayProfile profile = smallProfile();
  profile.rotationsPerMinute = 7500;
  return {.firmware = {.profile = profile}, .bytesPerSecond = bytesPerSecond, .faults = std::move(faults)};
}

class StreamDeviceTest : public testing::Test {
 protected:
  void open(EmulatedDeviceOptions options) {
    bus_ = std::make_unique<MemoryBus>(std::move(options));
    bus_->withDevice([&](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(&check_); });
    device_ = openStreamDevice(bus_->port(), {.kind = "test", .transferBytes = 2000, .stuckAfter = 200ms});
  }

  /// The next frame: random light, shown as soon as possible.
  std::shared_ptr<const FrameFence> send() {
    const Volume volume = madeVolume(device_->profile(), ++number_);
    check_.expect(number_, volume);
    const auto fence = device_->submit(volume);
    EXPECT_EQ(fence->number(), number_);
    device_->present(fence->number(), {});
    return fence;
  }

  /// Sends frames until one that was submitted after a fault has been shown.
  void expectStreamGoesOn() {
    const auto until = std::chrono::steady_clock::now() + kLong;
    while (std::chrono::steady_clock::now() < until) {
      if (send()->wait(FrameStage::kShown, 100ms).stage == FrameStage::kShown) {
        return;
      }
    }
    FAIL() << "no frame is shown any more: " << device_->telemetry().lastProblem;
  }

  void TearDown() override {
    device_.reset();
    EXPECT_EQ(check_.wrong(), 0u);
  }

  ArrivalCheck check_;
  std::unique_ptr<MemoryBus> bus_;
  std::unique_ptr<Device> device_;
  uint32_t number_ = 0;
};

TEST_F(StreamDeviceTest, knowsWhatItIsConnectedTo) {
  open(quickDisplay());
  EXPECT_EQ(device_->info().kind, "test");
  EXPECT_EQ(device_->info().name, "Ocelli emulated display");
  EXPECT_EQ(device_->info().serial, "EMULATED");
  EXPECT_EQ(device_->profile(), quickDisplay().firmware.profile);
}

TEST_F(StreamDeviceTest, framesArriveAndAreShown) {
  open(quickDisplay());
  for (int i = 0; i < 20; ++i) {
    const FrameState state = send()->wait(FrameStage::kShown, kLong);
    ASSERT_EQ(state.stage, FrameStage::kShown);
    EXPECT_EQ(state.shownSlice, 0);
    EXPECT_GT(state.bytes, 0u);
    EXPECT_NE(state.arrived, std::chrono::steady_clock::time_point{});
  }
  EXPECT_EQ(check_.right(), 20u);
  const Telemetry telemetry = device_->telemetry();
  EXPECT_EQ(telemetry.framesSubmitted, 20u);
  EXPECT_EQ(telemetry.framesArrived, 20u);
  EXPECT_EQ(telemetry.framesShown, 20u);
  EXPECT_EQ(telemetry.framesLost, 0u);
  EXPECT_EQ(telemetry.reconnections, 0u);
}

TEST_F(StreamDeviceTest, aSharedVolumeIsKeptAndNotCopied) {
  open(quickDisplay());
  const auto volume = std::make_shared<const Volume>(madeVolume(device_->profile(), 1));
  check_.expect(1, *volume);
  const auto fence = device_->submit(volume);
  EXPECT_GT(volume.use_count(), 1) << "a device that copied it would not hold it";
  device_->present(fence->number(), {});
  EXPECT_EQ(fence->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  device_ = nullptr;
  EXPECT_EQ(volume.use_count(), 1);
}

TEST_F(StreamDeviceTest, aFrameWithoutAPresentationIsNotShown) {
  open(quickDisplay());
  const Volume volume = madeVolume(device_->profile(), 1);
  check_.expect(1, volume);
  const auto fence = device_->submit(volume);
  EXPECT_EQ(fence->wait(FrameStage::kArrived, kLong).stage, FrameStage::kArrived);
  EXPECT_EQ(fence->wait(FrameStage::kShown, 30ms).stage, FrameStage::kArrived);
  device_->present(1, {});
  EXPECT_EQ(fence->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
}

TEST_F(StreamDeviceTest, aFrameIsShownAtItsPhase) {
  open(quickDisplay());
  send()->wait(FrameStage::kShown, kLong);
  std::optional<RotationReading> rotation;
  while (!(rotation = device_->telemetry().rotation)) {
    std::this_thread::sleep_for(1ms);
  }
  const Volume volume = madeVolume(device_->profile(), 2);
  check_.expect(2, volume);
  const auto fence = device_->submit(volume);
  const uint64_t refresh = rotation->refresh + 100;  // 0.4 s: the machine may be busy
  device_->present(2, {.at = RotationPhase{.refresh = refresh, .slice = 5}});
  const FrameState state = fence->wait(FrameStage::kShown, kLong);
  EXPECT_EQ(state.stage, FrameStage::kShown);
  EXPECT_EQ(state.shownRefresh, refresh);
  EXPECT_EQ(state.shownSlice, 5);
  EXPECT_FALSE(state.late);
}

TEST_F(StreamDeviceTest, deltasGiveTheSameFrames) {
  open(quickDisplay());
  Volume volume(device_->profile());
  Random random(9);
  for (uint32_t frame = 1; frame <= 30; ++frame) {
    const std::vector<int> changed = {static_cast<int>(random.below(11)), static_cast<int>(random.below(11))};
    for (const int slice : changed) {
      volume.light(slice, static_cast<int>(random.below(37)), static_cast<int>(random.below(19)), 3);
    }
    check_.expect(frame, volume);
    const auto fence = device_->submit(volume, changed);
    device_->present(frame, {});
    if (frame % 3 == 0) {
      EXPECT_EQ(fence->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
    }
  }
  EXPECT_GE(check_.right(), 10u);
}

TEST_F(StreamDeviceTest, theNewestWinsOnASlowLink) {
  open(quickDisplay({}, 200000));
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (int i = 0; i < 200; ++i) {
    fences.push_back(send());
    std::this_thread::sleep_for(500us);
  }
  EXPECT_EQ(fences.back()->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  size_t ended = 0;
  for (const auto& fence : fences) {
    ended += hasEnded(fence->wait(FrameStage::kShown, kLong).stage) ? 1 : 0;
  }
  EXPECT_EQ(ended, fences.size());
  const Telemetry telemetry = device_->telemetry();
  EXPECT_GT(telemetry.framesDropped, 0u);
  EXPECT_EQ(telemetry.framesShown + telemetry.framesDropped + telemetry.framesLost, fences.size());
}

TEST_F(StreamDeviceTest, closingEndsEverything) {
  open(quickDisplay({}, 20000));
  const auto first = send();
  const auto second = send();
  const auto third = send();
  device_->close();
  EXPECT_TRUE(hasEnded(first->state().stage));
  EXPECT_TRUE(hasEnded(second->state().stage));
  EXPECT_TRUE(hasEnded(third->state().stage));
}

TEST_F(StreamDeviceTest, aDisplayThatIsNotThereIsAnError) {
  FaultScript script{{{.kind = FaultKind::kUnplug, .duration = 3'600'000'000}}};
  MemoryBus bus(quickDisplay(script));
  std::this_thread::sleep_for(5ms);
  EXPECT_THROW(openStreamDevice(bus.port(), {.kind = "test"}), WorkError);
}

TEST_F(StreamDeviceTest, aStillVolumeComesBackAfterTheDisplayWasUnplugged) {
  open(quickDisplay({{{.kind = FaultKind::kUnplug, .at = 300'000, .duration = 50'000}}}));
  ASSERT_EQ(send()->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  const size_t before = check_.right();
  EXPECT_TRUE(check_.waitForMore(before, 5000ms));
  EXPECT_EQ(device_->telemetry().reconnections, 1u);
}

// Every frame is damaged for a while: the driver does not give up, and does not send at the speed of the link.
TEST_F(StreamDeviceTest, aDisplayThatRefusesManyFramesIsAskedMoreSlowly) {
  FaultScript script;
  for (uint32_t frame = 2; frame < 22; ++frame) {
    script.faults.push_back({.kind = FaultKind::kBitFlips, .afterFrames = frame, .afterBytes = 500, .amount = 40});
  }
  open(quickDisplay(script));
  ASSERT_EQ(send()->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(send()->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  // Twenty frames were lost: 0, 4, 8, ... 64, then 80 ms apart.
  EXPECT_GE(device_->telemetry().framesLost, 10u);
  EXPECT_GT(std::chrono::steady_clock::now() - start, 400ms);
}

// A display whose buffers are full takes nothing, which is not a broken link.
TEST_F(StreamDeviceTest, framesForLaterAreNotLostWhileTheDisplayWaits) {
  open(quickDisplay());
  while (!device_->telemetry().rotation) {
    std::this_thread::sleep_for(1ms);
  }
  const uint64_t now = device_->telemetry().rotation->refresh;
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (int i = 0; i < 4; ++i) {
    const Volume volume = madeVolume(device_->profile(), ++number_, 0.3);
    check_.expect(number_, volume);
    fences.push_back(device_->submit(volume));
    // 0.8 s, four times the time after which a link counts as stuck.
    device_->present(number_, {.at = RotationPhase{.refresh = now + 200 + static_cast<uint64_t>(i)}});
    fences.back()->wait(FrameStage::kArrived, 50ms);
  }
  for (const auto& fence : fences) {
    EXPECT_EQ(fence->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
  }
  EXPECT_EQ(device_->telemetry().framesLost, 0u);
}

// Frames that take a slow link longer than the time after which it counts as stuck, a transfer not.
TEST_F(StreamDeviceTest, largeFramesCrossASlowLink) {
  EmulatedDeviceOptions options = quickDisplay({}, 1e6);
  options.firmware.profile.width = 512;
  options.firmware.profile.height = 256;
  options.firmware.profile.slicesPerHalfTurn = 16;
  open(std::move(options));
  const Volume volume = madeVolume(device_->profile(), 1, 0.5);
  check_.expect(1, volume);
  const auto fence = device_->submit(volume);
  device_->present(1, {});
  const FrameState state = fence->wait(FrameStage::kShown, kLong);
  EXPECT_EQ(state.stage, FrameStage::kShown);
  EXPECT_GT(state.bytes, 400'000u);
  EXPECT_EQ(device_->telemetry().framesLost, 0u);
}

TEST_F(StreamDeviceTest, telemetryThatFailsChangesNothing) {
  open(quickDisplay({{{.kind = FaultKind::kDeafControl, .at = 100'000, .duration = 200'000}}}));
  send();
  const auto until = std::chrono::steady_clock::now() + 400ms;
  while (std::chrono::steady_clock::now() < until) {
    const Telemetry telemetry = device_->telemetry();
    ASSERT_TRUE(telemetry.rotation);
    ASSERT_LT(telemetry.rotation->refresh, 10'000u);
    ASSERT_NEAR(telemetry.rotation->refreshSeconds, 0.004, 0.002);
    std::this_thread::sleep_for(2ms);
  }
}

TEST_F(StreamDeviceTest, underrunsOfOthersAreNotItsOwn) {
  open(quickDisplay());
  const uint64_t past = 1;
  for (int i = 0; i < 3; ++i) {
    const Volume volume = madeVolume(device_->profile(), ++number_);
    check_.expect(number_, volume);
    const auto fence = device_->submit(volume);
    device_->present(number_, {.at = RotationPhase{.refresh = past}});
    fence->wait(FrameStage::kShown, kLong);
  }
  device_.reset();
  device_ = openStreamDevice(bus_->port(), {.kind = "test"});
  std::this_thread::sleep_for(120ms);
  EXPECT_EQ(device_->telemetry().underruns, 0u);
  EXPECT_TRUE(device_->telemetry().rotation);
}

// One test a fault, in the middle of a frame: the stream goes on, and nothing wrong is acknowledged.
class StreamFaultTest : public StreamDeviceTest, public testing::WithParamInterface<FaultKind> {};

TEST_P(StreamFaultTest, theStreamGoesOn) {
  const FaultKind kind = GetParam();
  Fault fault{.kind = kind, .afterFrames = 4, .afterBytes = 900, .duration = 30'000, .amount = 5};
  if (kind == FaultKind::kSlowLink) {
    fault.amount = 20000;
  } else if (kind == FaultKind::kPhaseDrift) {
    fault.amount = 1.05;
  }
  open(quickDisplay({{fault}}));
  for (int i = 0; i < 12; ++i) {
    send();
    std::this_thread::sleep_for(4ms);
  }
  const auto happened = [&] {
    bool some = false;
    bus_->withDevice([&](EmulatedDevice& device, DeviceMicroseconds) { some = !device.happened().empty(); });
    return some;
  };
  for (int i = 0; i < 1000 && !happened(); ++i) {
    send();
    std::this_thread::sleep_for(4ms);
  }
  EXPECT_TRUE(happened());
  std::this_thread::sleep_for(35ms);
  expectStreamGoesOn();
}

INSTANTIATE_TEST_SUITE_P(EveryFault, StreamFaultTest,
                         testing::Values(FaultKind::kStall, FaultKind::kShortWrite, FaultKind::kSlowLink,
                                         FaultKind::kUnplug, FaultKind::kWrongSequence, FaultKind::kBitFlips,
                                         FaultKind::kPhaseDrift, FaultKind::kFullBuffers, FaultKind::kDeafControl),
                         [](const auto& parameter) { return std::string(nameOf(parameter.param)); });

}  // namespace
}  // namespace ocelli
