// Random scripts of faults, many of them, against what must always hold.
#include <gtest/gtest.h>

#include <thread>

#include "display_driver/firmware/memory_bus.h"
#include "display_driver/wire/stream_device.h"
#include "tests/display_driver_wire/arrival_check.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

class RandomFaultsTest : public testing::TestWithParam<int> {};

// Eight scripts each, of four faults within 100 ms.
TEST_P(RandomFaultsTest, theStreamIsBackAndNothingWrongWasAcknowledged) {
  DisplayProfile profile = smallProfile();
  profile.rotationsPerMinute = 7500;
  for (uint64_t seed = 0; seed < 8; ++seed) {
    const FaultScript script = randomFaults(static_cast<uint64_t>(GetParam()) * 1000 + seed, 4, 100'000);
    SCOPED_TRACE(jsonText(script));
    ArrivalCheck check;
    EmulatedDeviceOptions options;
    options.firmware.profile = profile;
    options.firmware.frameBuffers = seed % 2 == 0 ? 2 : 3;
    options.bytesPerSecond = seed % 3 == 0 ? 2e6 : 0;
    options.faults = script;
    MemoryBus bus(options);
    bus.withDevice([&](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(&check); });
    std::unique_ptr<Device> device;
    while (device == nullptr) {
      try {
        device = openStreamDevice(bus.port(), {.kind = "test", .transferBytes = 2000, .stuckAfter = 100ms});
      } catch (const std::exception&) {
        std::this_thread::sleep_for(5ms);  // a script may begin with the display unplugged
      }
    }
    uint32_t number = 0;
    std::vector<std::shared_ptr<const FrameFence>> fences;
    const auto send = [&] {
      const Volume volume = madeVolume(profile, ++number);
      check.expect(number, volume);
      fences.push_back(device->submit(volume));
      EXPECT_EQ(fences.back()->number(), number);
      device->present(number, {});
      return fences.back();
    };
    const auto allOver = [&] {
      bool over = false;
      bus.withDevice([&](EmulatedDevice& emulated, DeviceMicroseconds) {
        over = emulated.happened().size() == script.faults.size() && emulated.quiet();
      });
      return over;
    };
    const auto start = std::chrono::steady_clock::now();
    while (!allOver()) {
      send();
      std::this_thread::sleep_for(3ms);
      ASSERT_LT(std::chrono::steady_clock::now() - start, 20s) << device->telemetry().lastProblem;
    }
    bool back = false;
    for (int i = 0; i < 200 && !back; ++i) {
      back = send()->wait(FrameStage::kShown, 50ms).stage == FrameStage::kShown;
    }
    EXPECT_TRUE(back) << device->telemetry().lastProblem;
    device->close();
    for (const auto& fence : fences) {
      EXPECT_TRUE(hasEnded(fence->state().stage));
    }
    EXPECT_EQ(check.wrong(), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFaultsTest, testing::Range(0, 5));

}  // namespace
}  // namespace ocelli
