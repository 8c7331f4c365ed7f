// A device without hardware: takes every frame at once and shows it in time on a screen that turns without any error.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "display_driver/device/device.h"
#include "display_driver/device/ideal_screen.h"

namespace ocelli {

/// What gets the frames as they are shown, on a thread of its own. Its exceptions end the device: later frames are
/// lost, and close() throws what it threw.
class ShownFrames {
 public:
  virtual ~ShownFrames() = default;
  /// From this time on, in the order of the times.
  virtual void shown(const Volume& volume, HostTime time) = 0;
  virtual void finish() = 0;
};

class IdealDevice final : public Device {
 public:
  /// The rotation begins now. `frames` may be nullptr.
  IdealDevice(DeviceInfo info, const DisplayProfile& profile, std::unique_ptr<ShownFrames> frames);
  ~IdealDevice() override;

  const DeviceInfo& info() const override { return info_; }
  const DisplayProfile& profile() const override { return profile_; }
  void present(FrameNumber frame, const Presentation& presentation) override;
  Telemetry telemetry() override;
  void close() override;

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>> changedSlices) override;

 private:
  /// A frame that was shown and has not been taken yet.
  struct Taken {
    std::shared_ptr<const Volume> volume;
    HostTime time;
  };
  void run();
  void advance();
  void end();

  const DeviceInfo info_;
  const DisplayProfile profile_;
  const std::unique_ptr<ShownFrames> frames_;

  std::mutex mutex_;
  std::condition_variable changed_;
  IdealScreen screen_;
  Telemetry counts_;
  FrameNumber lastNumber_ = 0;
  std::deque<Taken> toTake_;
  std::exception_ptr failure_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace ocelli
