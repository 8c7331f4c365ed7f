// What tests of links over an emulated USB share.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/usb/usb_port.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {

using namespace std::chrono_literals;

/// Ten times what anything here takes on a busy machine: where it passes, something hangs.
inline constexpr std::chrono::seconds kLong{20};

/// Bytes that are no message: the device takes them, and says that it understood nothing.
inline const std::vector<uint8_t> kNoise(size_t{1} << 18, 0x55);

class UsbTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!UsbEmulator::preloaded()) {
      const auto error = UsbEmulator::preloadError();
      GTEST_SKIP() << "no USB can be emulated: " << (error ? error->what() : "this program was not started anew");
    }
  }
  void TearDown() override { EXPECT_EQ(usbTransfersAlive(), 0u); }

 public:
  static EmulatedUsbDisplay display(const std::string& serial = "EMULATED") {
    EmulatedUsbDisplay made;
    made.device.firmware.profile = smallProfile();
    made.device.firmware.serial = serial;
    return made;
  }
};

/// Hears of all that a link reports.
class Listener {
 public:
  struct Sent {
    size_t tag;
    wire::LinkStatus status;
    size_t bytes;
    bool operator==(const Sent&) const = default;
  };

  wire::LinkListener functions() {
    return {.sent = [this](size_t tag, wire::LinkStatus status,
                           size_t bytes) { note([&] {
                                             sent_.push_back({tag, status, bytes});
                                           }); },
            .received =
                [this](std::span<const uint8_t> bytes) {
                  note([&] { received_.insert(received_.end(), bytes.begin(), bytes.end()); });
                },
            .lost = [this](wire::LinkStatus status) { note([&] { lost_.push_back(status); }); }};
  }

  /// So many sends, in the end.
  std::vector<Sent> waitForSent(size_t count) {
    return wait<std::vector<Sent>>([&] { return sent_.size() >= count; }, sent_);
  }
  std::vector<uint8_t> waitForReceived(size_t bytes) {
    return wait<std::vector<uint8_t>>([&] { return received_.size() >= bytes; }, received_);
  }
  std::vector<wire::LinkStatus> waitForLost() {
    return wait<std::vector<wire::LinkStatus>>([&] { return !lost_.empty(); }, lost_);
  }

 private:
  void note(const std::function<void()>& change) {
    const std::scoped_lock lock(mutex_);
    change();
    changed_.notify_all();
  }
  template <class Result>
  Result wait(const std::function<bool()>& reached, const Result& result) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kLong, reached)) << "this did not come in time";
    return result;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Sent> sent_;
  std::vector<uint8_t> received_;
  std::vector<wire::LinkStatus> lost_;
};

/// Until it holds, or for very long. Says which.
inline bool becomesTrue(const std::function<bool()>& holds) {
  for (const auto end = std::chrono::steady_clock::now() + kLong; std::chrono::steady_clock::now() < end;) {
    if (holds()) {
      return true;
    }
    std::this_thread::sleep_for(1ms);
  }
  return holds();
}

}  // namespace ocelli
