// Gives a device log to another device: the same volumes, submitted and presented at the same times.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/pacing/device_log_reader.h"
#include "display_driver/pacing/pace_clock.h"

namespace ocelli {

struct DeviceLogPlayerOptions {
  /// Each frame as soon as the one before was shown, instead of at its own time.
  bool fast = false;
};

struct DeviceLogPlayed {
  uint64_t submitted = 0;
  uint64_t presented = 0;
  uint64_t shown = 0;
  uint64_t dropped = 0;
  uint64_t lost = 0;
  double seconds = 0;  ///< from the first record to the last, as they were played
  RecordingEnding ending = RecordingEnding::kUnfinished;
  std::vector<std::shared_ptr<const FrameFence>> underWay{};  ///< frames that have not ended

  /// Counts those of underWay that have ended, and forgets them: once more after the device was closed, which ends all.
  void countEnded();
};

/// The phases at which frames were presented are carried over to the device's own count of refreshes, by where both
/// screens were at the same time; where one of them does not tell, and with `fast`, frames are shown with the next
/// refresh. The device has the log's profile. `stop` is asked now and then.
DeviceLogPlayed playDeviceLog(DeviceLogReader& reader, Device& device, PaceClock& clock,
                              const DeviceLogPlayerOptions& options = {}, const std::function<bool()>& stop = {});

}  // namespace ocelli
