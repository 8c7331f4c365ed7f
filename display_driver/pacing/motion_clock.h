// Which time of a motion is shown when.
#pragma once

#include <optional>

#include "display_driver/device/device.h"

namespace ocelli {

struct MotionPlayback {
  double speed = 1;   ///< seconds of the motion in one of the clock; positive
  bool loop = false;  ///< at its end it begins again
};

class MotionClock {
 public:
  MotionClock(double durationSeconds, const MotionPlayback& playback)
      : durationSeconds_(durationSeconds), playback_(playback) {}

  /// The seconds of the motion at that time; it begins with the first question. Nothing where it has ended.
  std::optional<double> at(HostTime seen);

 private:
  double durationSeconds_;
  MotionPlayback playback_;
  std::optional<HostTime> start_;
};

}  // namespace ocelli
