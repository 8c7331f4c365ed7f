// A display on a pseudo-terminal, and the driver at its other end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "display_driver/serial/pty_display.h"
#include "display_driver/serial/serial_link.h"
#include "oc_core/base/error.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr auto kLongLineWait = std::chrono::microseconds(30s);

/// The frame that arrived last.
class LastArrival : public ArrivalSink {
 public:
  void frameArrived(uint32_t /*session*/, uint32_t /*frame*/, const Volume& volume) override {
    const std::lock_guard lock(mutex_);
    last_ = volume;
    ++count_;
  }
  std::optional<Volume> last() const {
    const std::lock_guard lock(mutex_);
    return last_;
  }
  size_t count() const {
    const std::lock_guard lock(mutex_);
    return count_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Volume> last_;
  size_t count_ = 0;
};

class SerialLine : public testing::Test {
 protected:
  static EmulatedDeviceOptions options() {
    EmulatedDeviceOptions options;
    DisplayProfile& profile = options.firmware.profile;
    profile = loadProfile("test");
    profile.slicesPerHalfTurn = 10;
    profile.width = 24;
    profile.height = 16;
    profile.rotationsPerMinute = 6000;
    return options;
  }
  std::string place() const { return path_.string() + ",baud=921600"; }
  FrameState show(Device& device, const Volume& volume) const {
    const auto fence = device.submit(volume);
    device.present(fence->number(), {});
    return fence->wait(FrameStage::kShown, kLongLineWait);
  }
  template <class Condition>
  static bool happens(Condition&& condition) {
    const auto end = std::chrono::steady_clock::now() + kLongLineWait;
    while (!condition() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(1ms);
    }
    return condition();
  }

  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("ocelli_serial_line_" + std::to_string(getpid()));
};

std::string refusalOf(const std::string& place) {
  try {
    openSerialDevice(place);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(SerialLine, whatIsNotThereIsSaid) {
  EXPECT_THAT(refusalOf("/dev/no_such_line"), HasSubstr("/dev/no_such_line"));
  EXPECT_THAT(refusalOf("/dev/null"), HasSubstr("no serial device"));
  EXPECT_THAT(refusalOf("/dev/null,baud=12345"), HasSubstr("115200"));
  EXPECT_THAT(refusalOf(",baud=9600"), HasSubstr("must be a device"));
}

TEST_F(SerialLine, aLineOnWhichNobodyAnswersIsSaid) {
  EmulatedDeviceOptions silent = options();
  PtyDisplay display(silent, path_);
  display.setNoise(1);  // no byte comes through as it was
  EXPECT_THAT(refusalOf(place()), HasSubstr("answers at 921600 bit/s"));
}

TEST_F(SerialLine, framesArriveAsTheyWereSent) {
  PtyDisplay display(options(), path_);
  const std::unique_ptr<Device> device = openSerialDevice(place());
  EXPECT_EQ(device->info().kind, "serial");
  EXPECT_THAT(device->info().link, HasSubstr("921600"));
  EXPECT_EQ(device->profile(), options().firmware.profile);
  LastArrival check;
  display.withDevice([&](EmulatedDevice& emulated, DeviceMicroseconds) { emulated.firmware().setArrivalSink(&check); });
  for (uint64_t k = 1; k <= 10; ++k) {
    const Volume volume = madeVolume(device->profile(), k);
    const FrameState state = show(*device, volume);
    ASSERT_EQ(state.stage, FrameStage::kShown) << state.problem;
    EXPECT_EQ(check.last(), volume);
  }
  EXPECT_EQ(device->telemetry().framesLost, 0u);
  EXPECT_EQ(device->telemetry().reconnections, 0u);
  EXPECT_EQ(display.damagedPackets(), 0u);
}

TEST_F(SerialLine, onANoisyLineNothingIsLostAndNothingIsWrong) {
  PtyDisplay display(options(), path_);
  const std::unique_ptr<Device> device = openSerialDevice(place());
  LastArrival check;
  display.withDevice([&](EmulatedDevice& emulated, DeviceMicroseconds) { emulated.firmware().setArrivalSink(&check); });
  display.setNoise(3000);
  for (uint64_t k = 1; k <= 20; ++k) {
    const Volume volume = madeVolume(device->profile(), k);
    const FrameState state = show(*device, volume);
    ASSERT_EQ(state.stage, FrameStage::kShown) << state.problem;
    EXPECT_EQ(check.last(), volume);
  }
  EXPECT_GT(display.damagedPackets(), 0u);
  EXPECT_EQ(device->telemetry().framesLost, 0u) << "packets are sent again, below the frames";
}

TEST_F(SerialLine, aDisplayThatIsUnpluggedComesBackWithTheLastFrame) {
  LastArrival check;
  EmulatedDeviceOptions faulty = options();
  faulty.faults.faults = {{.kind = FaultKind::kUnplug, .afterFrames = 2, .duration = 300000}};
  PtyDisplay display(faulty, path_);
  display.withDevice([&](EmulatedDevice& emulated, DeviceMicroseconds) { emulated.firmware().setArrivalSink(&check); });
  const std::unique_ptr<Device> device = openSerialDevice(place());
  ASSERT_EQ(show(*device, madeVolume(device->profile(), 1)).stage, FrameStage::kShown);
  const Volume volume = madeVolume(device->profile(), 2);
  show(*device, volume);  // it may be lost, but not its image
  EXPECT_TRUE(happens([&] { return device->telemetry().reconnections >= 1; }));
  EXPECT_THAT(device->telemetry().lastProblem, Not(IsEmpty()));
  EXPECT_TRUE(happens([&] { return check.last() == volume; })) << "it is sent again";
  const Volume next = madeVolume(device->profile(), 3);
  EXPECT_EQ(show(*device, next).stage, FrameStage::kShown);
  EXPECT_EQ(check.last(), next);
  EXPECT_TRUE(device->telemetry().connected);
}

}  // namespace
}  // namespace ocelli
