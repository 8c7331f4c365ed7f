// Which part of the sweep an exposure sees, and how often. The still camera of dissertation section 3.5.5.6 exposes for
// 1/25 s where a refresh takes 1/24 s: it misses (1/24 - 1/25) x 12 x 360 = 7.2 degrees of the volume.
#pragma once

#include <vector>

#include "display_sim/display_profile.h"

namespace ocelli {

/// A part of the arc that the screen sweeps while one slice is on. Angles about the axis, as t of the slice convention.
struct ExposedArc {
  int slice = 0;
  double fromRadians = 0;
  double toRadians = 0;
  double passes = 0;  ///< how often the screen passes here during the exposure
};

/// The arcs that an exposure of `seconds` sees, by slice; dark ones are left out. The slices of a volume repeat with
/// the refresh of the display: every half turn, or every turn where the second half turn has its own. The exposure ends
/// when the screen stands at `endDegrees`, so a shorter one than a refresh misses a sector that starts there.
std::vector<ExposedArc> exposedArcs(const DisplayProfile& profile, double seconds, double endDegrees);

}  // namespace ocelli
