// The rotation of an emulated display: where its screen is at a time, as its own clock and its own slices count.
//
// A motor turns the screen at the profile's rate, with errors of its own: every refresh takes a little more or less
// (jitter), and the rate may be off (drift). A controller sees an index mark once a refresh and takes back a share of
// the distance to where an ideal rotor would be: the phase error is what is left. The random numbers are seeded.
#pragma once

#include <cstdint>

#include "display_sim/frames/display_profile.h"
#include "oc_core/base/random.h"

namespace ocelli {

/// Of the emulated device's clock, which starts at 0.
using DeviceMicroseconds = int64_t;

struct RotorOptions {
  double jitter = 0;            ///< standard deviation of a refresh's length, as a share of it; below 0.1
  double controllerGain = 0.2;  ///< share of the phase error that is taken back in the next refresh; 0: not locked
  uint64_t seed = 1;
};

class Rotor {
 public:
  Rotor(const DisplayProfile& profile, const RotorOptions& options);

  /// The refresh under way, counted from 0.
  uint64_t refresh() const { return refresh_; }
  DeviceMicroseconds begin() const;
  DeviceMicroseconds end() const;
  double lengthMicroseconds() const { return length_; }
  void nextRefresh();

  /// The slice that is shown at a time of this refresh.
  int sliceAt(DeviceMicroseconds now) const;
  /// When a slice of this refresh begins.
  DeviceMicroseconds beginOf(int slice) const;

  /// Of the screen at the begin of this refresh, in degrees of its rotation: negative behind an ideal rotor.
  double phaseErrorDegrees() const;
  /// Not further off than one slice.
  bool locked() const;
  /// The motor runs at another rate from the next refresh on; 1 is as it should.
  void setRate(double rate) { rate_ = rate; }

 private:
  void drawLength();

  int slices_;
  double idealMicroseconds_;
  double degreesPerRefresh_;
  RotorOptions options_;
  Random random_;
  double rate_ = 1;
  uint64_t refresh_ = 0;
  double begin_ = 0;  ///< in microseconds
  double length_ = 0;
};

}  // namespace ocelli
