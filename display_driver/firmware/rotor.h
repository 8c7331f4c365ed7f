// The rotation of an emulated display: where its screen is at a time, as its own clock and its own slices count.
//
// A motor turns the screen at the profile's rate, with errors of its own: every refresh takes a little more or less
// (jitter), and the rate may be off (drift). A controller that sees an index mark once a refresh pulls it back towards
// the place where an ideal rotor would be: the phase error is what is left. Sources of both are seeded.
#pragma once

#include <cstdint>

#include "display_sim/frames/display_profile.h"
#include "oc_core/base/random.h"

namespace ocelli {

/// Of the emulated device's clock, which starts at 0.
using DeviceMicroseconds = int64_t;

struct RotorOptions {
  double jitter = 0;            ///< standard deviation of a refresh's length, as a share of it
  double controllerGain = 0.2;  ///< share of the phase error that is taken back in the next refresh; 0: not locked
  uint64_t seed = 1;
};

struct RotorPlace {
  uint64_t refresh = 0;
  int slice = 0;                  ///< that is shown
  DeviceMicroseconds begin = 0;   ///< of the refresh
  DeviceMicroseconds length = 0;  ///< of the refresh

  auto operator<=>(const RotorPlace&) const = default;
};

class Rotor {
 public:
  Rotor(const DisplayProfile& profile, const RotorOptions& options);

  /// Times never go back.
  RotorPlace placeAt(DeviceMicroseconds now);
  /// When the slice after that of the last placeAt() begins.
  DeviceMicroseconds nextSlice() const;

  /// Of the screen behind an ideal rotor, at the begin of the current refresh; in degrees of its rotation.
  double phaseErrorDegrees() const;
  bool locked() const;
  /// The motor runs at another rate from the next refresh on: 1 is as it should.
  void setRate(double rate) { rate_ = rate; }

 private:
  void nextRefresh();

  int slices_;
  double idealMicroseconds_;
  double degreesPerRefresh_;
  RotorOptions options_;
  Random random_;
  double rate_ = 1;
  uint64_t refresh_ = 0;
  double begin_ = 0;   ///< in microseconds, not rounded
  double length_ = 0;
  int slice_ = 0;
};

}  // namespace ocelli
