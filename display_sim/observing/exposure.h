// Which part of the sweep an exposure sees, and how often. The still camera of dissertation section 3.5.5.6 exposes for
// 1/25 s where a refresh takes 1/24 s: it misses (1/24 - 1/25) x 12 x 360 = 7.2 degrees of the volume.
#pragma once

#include <vector>

#include "display_sim/frames/display_profile.h"
#include "display_sim/observing/wobble.h"

namespace ocelli {

/// What the screen sweeps during an exposure: angles about the axis, counted on over all turns.
struct Sweep {
  double fromRadians = 0;
  double toRadians = 0;

  double radians() const { return toRadians - fromRadians; }
};

/// Of an exposure that ends when the screen stands at `endDegrees`: a shorter one than a refresh misses a sector that
/// starts there.
Sweep sweepEndingAt(const DisplayProfile& profile, double seconds, double endDegrees);
/// Of an exposure that starts when the screen stands at `startDegrees`.
Sweep sweepStartingAt(const DisplayProfile& profile, double seconds, double startDegrees);

inline constexpr unsigned kAllChannels = 7;

/// A part of the arc that the screen sweeps while one slice is on. Angles about the axis, as t of the slice convention.
struct ExposedArc {
  int slice = 0;
  double fromRadians = 0;
  double toRadians = 0;
  double passes = 0;  ///< how often the screen passes here during the exposure
  /// Of these passes, those with the screen half a turn further than the angles say, so that it turns its other face to
  /// the eye: every second one where the second half turn mirrors the first.
  double turnedPasses = 0;
  unsigned channels = kAllChannels;  ///< that are on here: bit 0 red, bit 1 green, bit 2 blue
  double swingRadians = 0;           ///< the wobble's phase where the arc's angles are 0
};

/// Passes that find the display at phases of its wobble which differ by less than 1 / 64 of a swing count as one where
/// an exposure has more than 64 such phases: the error is below 5 % of the amplitude.
inline constexpr int kMaxWobblePhases = 64;

/// The arcs that a sweep sees, by slice; dark ones are left out. The slices of a volume repeat with the refresh of the
/// display: every half turn, or every turn where the second half turn has its own. Where channels are on in turn, an
/// arc holds one of them.
std::vector<ExposedArc> exposedArcs(const DisplayProfile& profile, const Sweep& sweep, const Wobble& wobble = {});

/// Cuts arcs where the channels of this display take turns.
std::vector<ExposedArc> splitByChannel(const DisplayProfile& profile, const std::vector<ExposedArc>& arcs);

}  // namespace ocelli
