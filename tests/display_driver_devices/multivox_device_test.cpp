#include "display_driver/devices/multivox_device.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <thread>

#include "oc_core/base/error.h"
#include "tests/display_driver_devices/acted_display.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using test::ActedDisplay;

constexpr auto kLongMultivoxWait = 20s;  // for what must happen; no test waits for it

/// Lit where a frame's number and a slice's say so: every frame differs from the others.
Volume volumeOf(const DisplayProfile& profile, unsigned number) {
  Volume volume(profile);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    const unsigned state = (number * 977 + static_cast<unsigned>(slice)) * 2654435761u;
    volume.light(slice, static_cast<int>(state >> 8) % volume.width() & ~1,
                 static_cast<int>(state >> 20) % volume.height(), 1 + number % 7);
  }
  return volume;
}

std::vector<uint8_t> cellsOf(const Volume& volume, int shownBits = 2) {
  VoxelResampler resampler(volume.profile(), {});
  resampler.update(volume, std::nullopt, shownBits);
  return {resampler.cells().begin(), resampler.cells().end()};
}

template <class Condition>
bool comesTrue(Condition&& condition) {
  const auto end = std::chrono::steady_clock::now() + kLongMultivoxWait;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

TEST(MultivoxDevice, isOpenedByName) {
  EXPECT_EQ(multivoxObject(""), "/vortex_double_buffer");
  EXPECT_EQ(multivoxObject("rotovox"), "/rotovox_double_buffer");
  EXPECT_EQ(multivoxObject("/of_my_own"), "/of_my_own");
  EXPECT_THROW(multivoxObject("a/b"), InputError);
  EXPECT_THROW(multivoxObject("/a/b"), InputError);
  EXPECT_THROW(multivoxObject("/"), InputError);
  EXPECT_THROW(multivoxObject(std::string(300, 'a')), InputError);
  const std::string object = test::uniqueObject();
  const std::unique_ptr<Device> device = openMultivox(object);
  EXPECT_EQ(device->info().kind, "multivox");
  EXPECT_EQ("/" + device->info().name, object);
  EXPECT_EQ(device->profile(), loadProfile("vortex"));
}

TEST(MultivoxDevice, showsWhatTheResamplerMakesAndTellsHowFarFramesAre) {
  ActedDisplay display(test::uniqueObject());
  display.setTelemetry(3, 615, 400);
  const std::unique_ptr<Device> device = openMultivox(display.object());
  const auto bytes = display.grid().cells();
  for (unsigned k = 1; k <= 3; ++k) {
    const Volume volume = volumeOf(device->profile(), k);
    const std::vector<uint8_t> before = display.shown();
    const auto fence = device->submit(volume);
    EXPECT_EQ(fence->number(), k);
    const FrameState arrived = fence->wait(FrameStage::kArrived, kLongMultivoxWait);
    EXPECT_EQ(arrived.stage, FrameStage::kArrived);
    EXPECT_EQ(arrived.bytes, bytes);
    EXPECT_EQ(display.shown(), before) << "it was not asked for yet";
    // There is no phase: one that never comes is shown at once.
    device->present(fence->number(), {.at = RotationPhase{.refresh = uint64_t{1} << 60}});
    const FrameState shown = fence->wait(FrameStage::kShown, kLongMultivoxWait);
    EXPECT_EQ(shown.stage, FrameStage::kShown);
    EXPECT_GE(shown.shown, shown.arrived);
    EXPECT_EQ(display.shown(), cellsOf(volume, 3));
  }
  const Telemetry telemetry = device->telemetry();
  EXPECT_TRUE(telemetry.connected);
  EXPECT_EQ(telemetry.rotationsPerMinute, 615);
  EXPECT_FALSE(telemetry.rotation);
  EXPECT_EQ(telemetry.framesSubmitted, 3u);
  EXPECT_EQ(telemetry.framesArrived, 3u);
  EXPECT_EQ(telemetry.framesShown, 3u);
  EXPECT_EQ(telemetry.framesDropped + telemetry.framesLost + telemetry.underruns + telemetry.reconnections, 0u);
  EXPECT_EQ(telemetry.bytesSent, 3 * (bytes + 1));
  EXPECT_EQ(telemetry.lastProblem, "");
}

TEST(MultivoxDevice, waitsForTheDisplayAndThenShowsTheNewest) {
  const std::string object = test::uniqueObject();
  const std::unique_ptr<Device> device = openMultivox(object);
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (unsigned k = 1; k <= 4; ++k) {
    fences.push_back(device->submit(volumeOf(device->profile(), k)));
    device->present(fences.back()->number(), {});
  }
  EXPECT_TRUE(comesTrue([&] { return !device->telemetry().lastProblem.empty(); }));
  EXPECT_FALSE(device->telemetry().connected);
  EXPECT_EQ(fences[3]->state().stage, FrameStage::kWaiting);
  const ActedDisplay display(object);
  EXPECT_EQ(fences[3]->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  EXPECT_EQ(display.shown(), cellsOf(volumeOf(device->profile(), 4)));
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(fences[static_cast<size_t>(k)]->state().stage, FrameStage::kDropped);
    EXPECT_NE(fences[static_cast<size_t>(k)]->state().problem, "");
  }
  EXPECT_EQ(device->telemetry().framesDropped, 3u);
  EXPECT_EQ(device->telemetry().reconnections, 0u);
}

TEST(MultivoxDevice, changesOfDroppedFramesAreNotLost) {
  const std::string object = test::uniqueObject();
  const std::unique_ptr<Device> device = openMultivox(object);
  Volume volume(device->profile());
  std::shared_ptr<const FrameFence> fence;
  for (int slice = 0; slice < 20; ++slice) {  // nobody reads yet: all but the last are dropped
    volume.light(slice, 90, 7, 7);
    const int changed[] = {slice};
    fence = device->submit(volume, changed);
  }
  device->present(fence->number(), {});
  const ActedDisplay display(object);
  EXPECT_EQ(fence->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  EXPECT_EQ(display.shown(), cellsOf(volume));
}

TEST(MultivoxDevice, aFrameThatNobodyAskedForGivesWayToANewerOne) {
  const ActedDisplay display(test::uniqueObject());
  const std::unique_ptr<Device> device = openMultivox(display.object());
  const auto first = device->submit(volumeOf(device->profile(), 1));
  EXPECT_EQ(first->wait(FrameStage::kArrived, kLongMultivoxWait).stage, FrameStage::kArrived);
  const auto second = device->submit(volumeOf(device->profile(), 2));
  EXPECT_EQ(second->wait(FrameStage::kArrived, kLongMultivoxWait).stage, FrameStage::kArrived);
  EXPECT_EQ(first->state().stage, FrameStage::kDropped);
  device->present(first->number(), {});  // too late, and harmless
  device->present(77, {});
  device->present(second->number(), {});
  EXPECT_EQ(second->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  EXPECT_EQ(display.shown(), cellsOf(volumeOf(device->profile(), 2)));
  EXPECT_EQ(device->telemetry().framesDropped, 1u);
}

TEST(MultivoxDevice, aStillImageComesBackWithTheDisplay) {
  ActedDisplay display(test::uniqueObject());
  const std::unique_ptr<Device> device = openMultivox(display.object());
  const Volume volume = volumeOf(device->profile(), 1);
  const auto fence = device->submit(volume);
  device->present(fence->number(), {});
  ASSERT_EQ(fence->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  // A frame that arrived and waits is not lost with the memory either.
  const Volume next = volumeOf(device->profile(), 2);
  const auto waiting = device->submit(next);
  ASSERT_EQ(waiting->wait(FrameStage::kArrived, kLongMultivoxWait).stage, FrameStage::kArrived);
  display.restart();
  EXPECT_TRUE(comesTrue([&] { return display.shown() == cellsOf(volume); }));
  device->present(waiting->number(), {});
  EXPECT_EQ(waiting->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  EXPECT_EQ(display.shown(), cellsOf(next));
  const Telemetry telemetry = device->telemetry();
  EXPECT_EQ(telemetry.reconnections, 1u);
  EXPECT_EQ(telemetry.framesArrived, 2u);
  EXPECT_EQ(telemetry.framesShown, 2u);
}

TEST(MultivoxDevice, closingEndsWhatWaitsAndKeepsTheImage) {
  const ActedDisplay display(test::uniqueObject());
  const std::unique_ptr<Device> device = openMultivox(display.object());
  const Volume volume = volumeOf(device->profile(), 1);
  const auto shown = device->submit(volume);
  device->present(shown->number(), {});
  ASSERT_EQ(shown->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  const auto waiting = device->submit(volumeOf(device->profile(), 2));
  ASSERT_EQ(waiting->wait(FrameStage::kArrived, kLongMultivoxWait).stage, FrameStage::kArrived);
  device->close();
  EXPECT_EQ(waiting->state().stage, FrameStage::kLost);
  EXPECT_NE(waiting->state().problem, "");
  EXPECT_EQ(device->telemetry().framesLost, 1u);
  EXPECT_EQ(display.shown(), cellsOf(volume));
}

TEST(MultivoxDevice, takesOtherProfiles) {
  const ActedDisplay display(test::uniqueObject());
  DisplayProfile profile = loadProfile("test");
  profile.secondHalfTurn = SecondHalfTurn::kOwn;
  profile.colorBitsPerChannel = 3;
  const std::unique_ptr<Device> device = openMultivox(display.object(), profile);
  const Volume volume = volumeOf(profile, 5);
  const auto fence = device->submit(volume);
  device->present(fence->number(), {});
  EXPECT_EQ(fence->wait(FrameStage::kShown, kLongMultivoxWait).stage, FrameStage::kShown);
  EXPECT_EQ(display.shown(), cellsOf(volume));
}

}  // namespace
}  // namespace ocelli
