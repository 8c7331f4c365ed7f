// What holds for every device.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>

#include "display_driver/devices/device_kinds.h"
#include "display_sim/frames/svol_player.h"
#include "oc_core/base/error.h"
#include "tests/display_driver_devices/test_devices.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

// Nothing here takes so long unless a device hangs.
constexpr auto kLong = std::chrono::microseconds(30s);

class DeviceContract : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("ocelli_device_" + GetParam() + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    if (const auto& surroundings = test::testDevices().at(GetParam()).surroundings) {
      surroundings_ = surroundings();
    }
    open();
  }
  void TearDown() override {
    device = nullptr;
    surroundings_ = nullptr;
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  const std::function<std::string(const std::string&)>& rest() { return test::testDevices().at(GetParam()).rest; }
  std::string kind() const {
    const char* const other = test::testDevices().at(GetParam()).kind;
    return other != nullptr ? other : GetParam();
  }
  void open() { device = openDevice(kind() + rest()(folder_), {.profile = test::fastProfile()}); }
  Volume volume(uint64_t seed) { return madeVolume(device->profile(), seed); }
  FrameState show(const Volume& shown, const Presentation& presentation = {}) {
    const auto fence = device->submit(shown);
    device->present(fence->number(), presentation);
    return fence->wait(FrameStage::kShown, kLong);
  }
  /// Where the screen will be after so many refreshes; nullopt where the device does not tell its rotation.
  std::optional<RotationPhase> after(uint64_t refreshes) {
    // Devices that tell it do so within some milliseconds after they were opened.
    const auto end = std::chrono::steady_clock::now() + 200ms;
    auto reading = device->telemetry().rotation;
    while (!reading && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(1ms);
      reading = device->telemetry().rotation;
    }
    return reading ? std::optional(RotationPhase{reading->refresh + refreshes, 0}) : std::nullopt;
  }

  std::filesystem::path folder_;
  std::shared_ptr<void> surroundings_;
  std::unique_ptr<Device> device;
};

TEST_P(DeviceContract, saysWhatItIs) {
  EXPECT_EQ(device->info().kind, kind());
  EXPECT_FALSE(device->info().name.empty());
  EXPECT_FALSE(device->info().link.empty());
  EXPECT_GT(device->profile().storedSlices(), 0);
}

TEST_P(DeviceContract, closesWithoutAnything) {
  device->close();
}

TEST_P(DeviceContract, framesAreCountedFromOne) {
  EXPECT_EQ(device->submit(volume(1))->number(), 1u);
  EXPECT_EQ(device->submit(volume(2))->number(), 2u);
  EXPECT_EQ(device->telemetry().framesSubmitted, 2u);
}

TEST_P(DeviceContract, aPresentedFrameIsShown) {
  const FrameState state = show(volume(1));
  EXPECT_EQ(state.stage, FrameStage::kShown) << state.problem;
  // When it was sent the host says, the rest the device, whose clock is known to within a few milliseconds.
  EXPECT_LE(state.sent, state.arrived + 20ms);
  EXPECT_LE(state.arrived, state.shown);
  EXPECT_NE(state.sent, HostTime());
  const Telemetry telemetry = device->telemetry();
  EXPECT_TRUE(telemetry.connected);
  EXPECT_EQ(telemetry.framesArrived, 1u);
  EXPECT_EQ(telemetry.framesShown, 1u);
}

TEST_P(DeviceContract, aFrameIsNotShownBeforeItsPhase) {
  const auto at = after(20);
  ASSERT_EQ(at.has_value(), test::testDevices().at(GetParam()).tellsRotation);
  if (!at) {
    return;
  }
  const FrameState state = show(volume(1), {.at = at});
  ASSERT_EQ(state.stage, FrameStage::kShown) << state.problem;
  EXPECT_GE((RotationPhase{state.shownRefresh, state.shownSlice}), *at);
  EXPECT_EQ(state.late, state.shownRefresh > at->refresh || state.shownSlice > at->slice);
}

TEST_P(DeviceContract, framesThatComeTooLateAreShownAsSuch) {
  show(volume(1));
  const auto past = after(0);
  ASSERT_EQ(past.has_value(), test::testDevices().at(GetParam()).tellsRotation);
  if (!past) {
    return;
  }
  std::this_thread::sleep_for(20ms);
  const FrameState state = show(volume(2), {.at = past, .tearWhenLate = true});
  EXPECT_EQ(state.stage, FrameStage::kShown) << state.problem;
  EXPECT_TRUE(state.late);
}

TEST_P(DeviceContract, oneOfManyFramesIsShownAndItIsTheNewest) {
  std::vector<std::shared_ptr<const FrameFence>> fences;
  const auto at = after(20);
  for (uint64_t i = 0; i < 12; ++i) {
    fences.push_back(device->submit(volume(i)));
    device->present(fences.back()->number(), {.at = at});
  }
  const FrameState last = fences.back()->wait(FrameStage::kShown, kLong);
  EXPECT_EQ(last.stage, FrameStage::kShown) << last.problem;
  size_t shown = 0;
  size_t dropped = 0;
  for (const auto& fence : fences) {
    const FrameStage stage = fence->wait(FrameStage::kShown, kLong).stage;
    shown += stage == FrameStage::kShown ? 1 : 0;
    dropped += stage == FrameStage::kDropped ? 1 : 0;
  }
  EXPECT_EQ(shown + dropped, fences.size());
  EXPECT_GE(dropped, 1u);
  EXPECT_EQ(device->telemetry().framesDropped, dropped);
}

TEST_P(DeviceContract, framesWithoutPresentAreNotShown) {
  const auto waits = device->submit(volume(1));
  ASSERT_EQ(waits->wait(FrameStage::kArrived, kLong).stage, FrameStage::kArrived);
  const FrameState state = show(volume(2));
  EXPECT_EQ(state.stage, FrameStage::kShown) << state.problem;
  EXPECT_EQ(waits->wait(FrameStage::kShown, kLong).stage, FrameStage::kDropped);
}

TEST_P(DeviceContract, presentOfOtherFramesDoesNothing) {
  device->present(0, {});
  device->present(77, {});
  const auto fence = device->submit(volume(1));
  device->present(fence->number(), {});
  fence->wait(FrameStage::kShown, kLong);
  device->present(fence->number(), {});
  EXPECT_EQ(device->telemetry().framesShown, 1u);
}

TEST_P(DeviceContract, submittedVolumesAreTheDevicesOwn) {
  Volume mine = volume(1);
  const auto fence = device->submit(mine);
  mine.clear();
  device->present(fence->number(), {});
  EXPECT_EQ(fence->wait(FrameStage::kShown, kLong).stage, FrameStage::kShown);
}

TEST_P(DeviceContract, framesOfWhichAPartChangedAreTaken) {
  Volume mine(device->profile());
  for (int i = 0; i < 6; ++i) {
    mine.light(i, 3, 4, 7);
    const std::vector<int> changed = {i};
    const auto fence = i == 0 ? device->submit(mine) : device->submit(mine, changed);
    device->present(fence->number(), {});
    const FrameState state = fence->wait(FrameStage::kShown, kLong);
    EXPECT_EQ(state.stage, FrameStage::kShown) << state.problem;
  }
}

TEST_P(DeviceContract, closingEndsEveryFrame) {
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (uint64_t i = 0; i < 6; ++i) {
    fences.push_back(device->submit(volume(i)));
    if (i % 2 == 0) {
      device->present(fences.back()->number(), {.at = RotationPhase{1'000'000'000 + i, 0}});
    }
  }
  std::thread waits([fence = fences.back()] { fence->wait(FrameStage::kShown, kLong); });
  device->close();
  waits.join();
  for (const auto& fence : fences) {
    EXPECT_TRUE(hasEnded(fence->state().stage)) << fence->number();
    EXPECT_NE(fence->state().stage == FrameStage::kShown, !fence->state().problem.empty());
  }
}

TEST_P(DeviceContract, theDestructorEndsEveryFrameToo) {
  const auto fence = device->submit(volume(1));
  device = nullptr;
  EXPECT_TRUE(hasEnded(fence->state().stage));
}

TEST_P(DeviceContract, opensAgainAfterClosing) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(show(volume(1)).stage, FrameStage::kShown);
    device->close();
    open();
  }
}

TEST_P(DeviceContract, threadsMayCallAnythingAtAnyTime) {
  std::atomic<uint64_t> submitted = 0;
  std::mutex mutex;
  std::vector<std::shared_ptr<const FrameFence>> fences;
  const auto submits = [&](uint64_t seed) {
    const Volume mine = volume(seed);
    for (int i = 0; i < 40; ++i) {
      auto fence = device->submit(mine);
      device->present(fence->number(), {.tearWhenLate = true});
      ++submitted;
      const std::lock_guard lock(mutex);
      fences.push_back(std::move(fence));
    }
  };
  const auto asks = [&] {
    Telemetry before;
    for (int i = 0; i < 100; ++i) {
      const Telemetry now = device->telemetry();
      EXPECT_GE(now.framesSubmitted, before.framesSubmitted);
      EXPECT_GE(now.framesShown, before.framesShown);
      before = now;
    }
  };
  std::vector<std::thread> threads;
  threads.emplace_back(submits, 1);
  threads.emplace_back(submits, 2);
  threads.emplace_back(asks);
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(device->telemetry().framesSubmitted, submitted);
  device->close();
  for (const auto& fence : fences) {
    EXPECT_TRUE(hasEnded(fence->state().stage)) << fence->number();
  }
}

std::vector<std::string> kindsToOpen() {
  std::vector<std::string> names;
  for (const DeviceKind& kind : deviceKinds()) {
    for (const auto& [name, device] : test::testDevices()) {
      if (device.rest != nullptr && (device.kind != nullptr ? device.kind : name) == kind.name) {
        names.push_back(name);
      }
    }
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(EveryKind, DeviceContract, testing::ValuesIn(kindsToOpen()),
                         [](const auto& kind) { return kind.param; });

class FileDeviceTest : public testing::Test {
 protected:
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("ocelli_file_device_" + std::to_string(getpid()) + ".svol");
  ~FileDeviceTest() override { std::filesystem::remove(path); }
};

TEST_F(FileDeviceTest, theFileHoldsWhatWasShownAndWhen) {
  const auto device = openDevice("file:" + path.string(), {.profile = test::fastProfile()});
  std::vector<Volume> volumes;
  std::vector<FrameState> states;
  for (uint64_t i = 0; i < 5; ++i) {
    volumes.push_back(madeVolume(device->profile(), i));
    const auto fence = device->submit(volumes.back());
    device->present(fence->number(), {});
    states.push_back(fence->wait(FrameStage::kShown, kLong));
    ASSERT_EQ(states.back().stage, FrameStage::kShown);
  }
  device->submit(madeVolume(device->profile(), 99));  // is never shown
  device->close();

  SvolReader reader(path);
  EXPECT_EQ(reader.ending(), SvolEnding::kFinished);
  ASSERT_EQ(reader.frames().size(), volumes.size());
  SvolPlayer player(reader);
  for (size_t i = 0; i < volumes.size(); ++i) {
    player.seek(i);
    EXPECT_EQ(player.volume(), volumes[i]);
    const auto since = std::chrono::duration_cast<std::chrono::microseconds>(states[i].shown - states[0].shown);
    EXPECT_EQ(reader.frames()[i].timeMicroseconds, static_cast<uint64_t>(since.count()));
  }
}

TEST_F(FileDeviceTest, withoutCloseItIsAnUnfinishedRecording) {
  auto device = openDevice("file:" + path.string(), {.profile = test::fastProfile()});
  const auto fence = device->submit(madeVolume(device->profile(), 1));
  device->present(fence->number(), {});
  fence->wait(FrameStage::kShown, kLong);
  device = nullptr;
  const SvolReader reader(path);
  EXPECT_EQ(reader.ending(), SvolEnding::kUnfinished);
  EXPECT_EQ(reader.frames().size(), 1u);
}

TEST_F(FileDeviceTest, aFullDiskIsSaidWhenItIsOpened) {
  EXPECT_THROW(openDevice("file:/dev/full", {.profile = test::fastProfile()}), WorkError);
}

}  // namespace
}  // namespace ocelli
