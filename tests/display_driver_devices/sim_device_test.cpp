#include "display_driver/devices/sim_device.h"

#include <gtest/gtest.h>

#include <mutex>
#include <thread>
#include <utility>

#include "display_driver/devices/shown_images.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

constexpr auto kLongSimWait = 10s;

/// Keeps the last whole refresh of a frame.
class LastShown : public RefreshSink {
 public:
  void refreshEnded(const ShownRefresh& refresh, const Volume& volume) override {
    const std::lock_guard lock(mutex_);
    if (refresh.parts.size() == 1) {
      frame_ = refresh.parts.front().frame;
      volume_ = std::make_unique<Volume>(volume);
    }
  }
  bool shows(uint32_t frame, const Volume& volume) const {
    const std::lock_guard lock(mutex_);
    return frame_ == frame && *volume_ == volume;
  }

 private:
  mutable std::mutex mutex_;
  uint32_t frame_ = 0;
  std::unique_ptr<Volume> volume_;
};

TEST(SimDevice, showsWhatWasSent) {
  DisplayProfile profile = smallProfile(24, 2);
  profile.rotationsPerMinute = 7500;
  LastShown shown;
  SimOptions options;
  options.display.firmware.profile = profile;
  options.display.firmware.rotor.jitter = 0.01;
  options.sink = &shown;
  const auto device = openSimDevice(options);
  EXPECT_EQ(device->info().kind, "sim");
  const Volume volume = madeVolume(profile, 4);
  const auto fence = device->submit(volume);
  device->present(fence->number(), {});
  ASSERT_EQ(fence->wait(FrameStage::kShown, kLongSimWait).stage, FrameStage::kShown);
  const auto until = std::chrono::steady_clock::now() + kLongSimWait;
  while (!shown.shows(fence->number(), volume)) {
    ASSERT_LT(std::chrono::steady_clock::now(), until);
    std::this_thread::sleep_for(1ms);
  }
}

// A slice further is what one step of the phase does: a volume that is turned by one slice, seen by the straight eye,
// and the straight volume seen by the eye for that phase error, are the same image but for rounding.
TEST(ShownImages, aPhaseErrorTurnsTheImage) {
  DisplayProfile profile = loadProfile("test");
  Volume straight(profile);
  Volume turned(profile);
  for (int i = 0; i < 3; ++i) {
    straight.light(4 + i, 50, 20 + 5 * i, 7);
    turned.light(5 + i, 50, 20 + 5 * i, 7);
  }
  ObserverOptions options;
  options.eye = {1, 2, 9};
  options.width = 96;
  options.height = 96;
  const Image<glm::vec3> expected = collectLight(turned, options);
  options.eye = eyeForPhaseError(options.eye, 180.0 / profile.slicesPerHalfTurn);
  const Image<glm::vec3> seen = collectLight(straight, options);
  double difference = 0;
  double light = 0;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      difference += std::abs(static_cast<double>(seen(x, y).g) - static_cast<double>(expected(x, y).g));
      light += static_cast<double>(expected(x, y).g);
    }
  }
  EXPECT_GT(light, 0);
  // The default emission is even, so that nothing but single precision differs.
  EXPECT_LT(difference, 1e-3 * light);
}

}  // namespace
}  // namespace ocelli
