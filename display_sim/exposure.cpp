#include "display_sim/exposure.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// In [0, period).
double wrapped(double angle, double period) {
  const double rest = std::fmod(angle, period);
  return rest < 0 ? rest + period : rest;
}

}  // namespace

std::vector<ExposedArc> exposedArcs(const DisplayProfile& profile, double seconds, double endDegrees) {
  const double step = kPi / profile.slicesPerHalfTurn;
  const double period = step * profile.storedSlices();
  const double swept = profile.rotationsPerMinute / 60 * 2 * kPi * seconds;
  // Below this an arc is rounding, as where the exposure is a whole number of refreshes.
  const double least = step * 1e-9;
  double wholePasses = std::floor((swept + least) / period);
  const double rest = std::max(swept - wholePasses * period, 0.0);
  const double end = radiansFromDegrees(endDegrees);

  std::vector<ExposedArc> arcs;
  for (int slice = 0; slice < profile.storedSlices(); ++slice) {
    const double from = (slice - 0.5) * step;
    // The arc is cut where the exposure begins and ends its last, incomplete pass.
    std::vector<double> cuts = {0, step};
    for (const double cut : {wrapped(end - rest - from, period), wrapped(end - from, period)}) {
      if (cut < step) {
        cuts.push_back(cut);
      }
    }
    std::ranges::sort(cuts);
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double middle = from + (cuts[i] + cuts[i + 1]) / 2;
      const bool inRest = wrapped(middle - (end - rest), period) < rest;
      const double passes = wholePasses + (inRest ? 1 : 0);
      if (passes > 0 && cuts[i + 1] - cuts[i] > least) {
        arcs.push_back({slice, from + cuts[i], from + cuts[i + 1], passes});
      }
    }
  }
  return arcs;
}

}  // namespace ocelli
