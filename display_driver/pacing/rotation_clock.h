// When the screen is at a phase of its rotation, estimated from readings that come now and then, late, jittered, or not
// at all: a phase-locked loop, as a Kalman filter of two numbers (the refreshes that have passed, and their rate).
//
// What is told of the motor: its rate wanders by a thousandth of itself in a second, and each refresh is longer or
// shorter by a thousandth. How much readings jitter is learned from them. A reading that cannot be right is left out;
// where several in a row say the same, the rotation has made a step (another speed, a restart), and the clock begins
// anew.
#pragma once

#include <cstdint>
#include <optional>

#include "display_driver/device/device.h"

namespace ocelli {

class RotationClock {
 public:
  /// How long a refresh should take.
  explicit RotationClock(double refreshSeconds);

  /// Readings that are older than the last one are left out.
  void add(const RotationReading& reading);

  /// There has been a reading. All that follows needs one.
  bool running() const { return running_; }
  /// Refreshes that have passed at a time, with the share of the one under way; never below 0.
  double refreshesAt(HostTime time) const;
  /// The first refresh that begins at this time or later.
  uint64_t refreshAfter(HostTime time) const;
  HostTime beginOf(uint64_t refresh) const { return timeOf(static_cast<double>(refresh)); }
  HostTime timeOf(double refreshes) const;
  double refreshSeconds() const { return 1 / rate_; }
  /// Standard deviation of what the clock says about this time.
  double uncertaintySeconds(HostTime time) const;

  /// How often it began anew. Refreshes are then counted from somewhere else.
  uint64_t restarts() const { return restarts_; }

 private:
  /// Symmetric, of (refreshes, rate).
  struct Covariance {
    double pp = 0;
    double pr = 0;
    double rr = 0;
  };
  void begin(const RotationReading& reading);
  Covariance ahead(double seconds) const;
  double secondsSince(HostTime time) const;

  double idealRate_;  ///< refreshes a second
  bool running_ = false;
  HostTime time_;  ///< of the last reading that was used
  HostTime heard_;
  uint64_t base_ = 0;  ///< refreshes are counted from here, so that small numbers stay exact
  double refreshes_ = 0;
  double rate_;
  Covariance covariance_;
  double readingVariance_ = 0;  ///< in refreshes squared
  int unlikely_ = 0;            ///< readings in a row
  uint64_t restarts_ = 0;
};

}  // namespace ocelli
