// The time, and waiting for it: real, or of a test that runs as fast as it can.
#pragma once

#include "display_driver/device/device.h"

namespace ocelli {

class PaceClock {
 public:
  virtual ~PaceClock() = default;
  virtual HostTime now() = 0;
  /// Returns at once for times that have passed.
  virtual void waitUntil(HostTime time) = 0;
};

/// std::chrono::steady_clock.
PaceClock& realClock();

}  // namespace ocelli
