#include "tests/display_driver_usb/fault_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/usb/usb_port.h"
#include "display_driver/wire/stream_device.h"
#include "tests/display_driver_wire/arrival_check.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr size_t kFaults = 4;
constexpr DeviceMicroseconds kOver = 300'000;
constexpr std::chrono::milliseconds kBetweenFrames{12};
constexpr std::chrono::seconds kForever{60};  // nothing here takes so long, on the slowest machine

/// Notes when frames were acknowledged, too.
class TimedCheck : public ArrivalCheck {
 public:
  void frameArrived(uint32_t session, uint32_t frame, const Volume& volume) override {
    ArrivalCheck::frameArrived(session, frame, volume);
    const std::lock_guard lock(timesMutex_);
    times_.push_back(Clock::now());
  }
  std::vector<Clock::time_point> times() const {
    const std::lock_guard lock(timesMutex_);
    return times_;
  }

 private:
  mutable std::mutex timesMutex_;
  std::vector<Clock::time_point> times_;
};

std::unique_ptr<Device> openAtLast(std::vector<std::string>& problems) {
  const Clock::time_point start = Clock::now();
  for (std::string last;; std::this_thread::sleep_for(5ms)) {
    try {
      return openStreamDevice(std::make_unique<UsbPort>(UsbPortOptions{.sendTimeout = 300ms, .requestTimeout = 300ms}),
                              {.kind = "usb", .stuckAfter = 100ms});
    } catch (const std::exception& error) {
      last = error.what();  // a script may begin with the display unplugged
    }
    if (Clock::now() - start > kForever) {
      problems.push_back(fmt::format("the display cannot be opened: {}", last));
      return nullptr;
    }
  }
}

std::vector<double> rotationsToReturn(const std::vector<EmulatedDevice::HappenedFault>& faults,
                                      const std::vector<Clock::time_point>& arrivals, Clock::time_point start,
                                      double rotationSeconds) {
  std::vector<double> rotations;
  for (const auto& fault : faults) {
    const Clock::time_point end = start + std::chrono::microseconds(fault.end);
    const auto next = std::ranges::upper_bound(arrivals, end);
    const bool followed = std::ranges::any_of(faults, [&](const auto& other) {
      return &other != &fault && other.end >= fault.end &&
             (next == arrivals.end() || start + std::chrono::microseconds(other.begin) < *next);
    });
    if (!followed && next != arrivals.end()) {
      rotations.push_back(std::chrono::duration<double>(*next - end).count() / rotationSeconds);
    }
  }
  return rotations;
}

}  // namespace

Holdings holdingsOfThisProcess() {
  const auto count = [](const char* folder) {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
  };
  return {.threads = count("/proc/self/task"), .descriptors = count("/proc/self/fd"), .transfers = usbTransfersAlive()};
}

FaultRunResult runRandomFaults(uint64_t seed) {
  FaultRunResult result;
  const FaultScript script = randomFaults(seed, kFaults, kOver);
  EmulatedUsbDisplay display;
  DisplayProfile& profile = display.device.firmware.profile;
  profile = smallProfile(60);
  profile.width = 96;
  profile.height = 64;
  profile.rotationsPerMinute = 720;
  display.device.firmware.frameBuffers = seed % 2 == 0 ? 2 : 3;
  display.device.bytesPerSecond = seed % 3 == 0 ? 10e6 : 0;
  display.device.faults = script;
  TimedCheck check;
  UsbEmulator emulator({display});
  Clock::time_point start;
  emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds now) {
    device.firmware().setArrivalSink(&check);
    start = Clock::now() - std::chrono::microseconds(now);
  });
  const std::unique_ptr<Device> device = openAtLast(result.problems);
  if (device == nullptr) {
    return result;
  }
  std::vector<std::shared_ptr<const FrameFence>> fences;
  const auto send = [&] {
    const auto number = static_cast<FrameNumber>(fences.size() + 1);
    const Volume volume = madeVolume(profile, seed * 1000 + number);
    check.expect(number, volume);
    fences.push_back(device->submit(volume));
    device->present(number, {});
    return fences.back();
  };
  const auto allOver = [&] {
    bool over = false;
    emulator.use(0, [&](EmulatedDevice& emulated, DeviceMicroseconds) {
      over = emulated.happened().size() == script.faults.size() && emulated.quiet();
    });
    return over;
  };
  while (!allOver() && Clock::now() - start < kForever) {
    send();
    std::this_thread::sleep_for(kBetweenFrames);
  }
  // Any of them, not just the newest: a slow machine may need longer for a frame than it takes until the next one.
  const auto first = static_cast<std::ptrdiff_t>(fences.size());
  bool back = false;
  for (const Clock::time_point now = Clock::now(); !back && Clock::now() - now < kForever;) {
    send()->wait(FrameStage::kShown, 200ms);
    back = std::any_of(fences.begin() + first, fences.end(),
                       [](const auto& fence) { return fence->state().stage == FrameStage::kShown; });
  }
  if (!back) {
    result.problems.push_back(fmt::format("the stream did not come back: {}", device->telemetry().lastProblem));
  }
  const Telemetry telemetry = device->telemetry();
  device->close();
  if (!std::ranges::all_of(fences, [](const auto& fence) { return hasEnded(fence->state().stage); })) {
    result.problems.emplace_back("a frame did not end with its device");
  }
  if (check.wrong() > 0) {
    result.problems.push_back(fmt::format("{} acknowledged frames differ from what was submitted", check.wrong()));
  }
  emulator.use(0, [&](EmulatedDevice& emulated, DeviceMicroseconds) {
    emulated.firmware().setArrivalSink(nullptr);
    result.faults = emulated.happened().size();
    result.rotationsToReturn =
        rotationsToReturn(emulated.happened(), check.times(), start, 60 / profile.rotationsPerMinute);
  });
  if (!result.problems.empty()) {
    result.problems.push_back(fmt::format("the script was {}", jsonText(script)));
  }
  result.framesSubmitted = fences.size();
  result.framesAcknowledged = check.right();
  result.reconnections = telemetry.reconnections;
  return result;
}

}  // namespace ocelli
