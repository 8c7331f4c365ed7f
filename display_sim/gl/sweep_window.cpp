#include "display_sim/gl/sweep_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kSameSwing = 1e-6;

void validate(const SweepWindow& window) {
  const auto fail = [](const std::string& what, const std::string& next) {
    throw InputError(what, "sweep window", next);
  };
  constexpr double kMaxRadians = 1e6;  // beyond, angles lose their precision
  if (!(std::abs(window.endRadians) <= kMaxRadians)) {
    fail("the screen's angle must lie within a million radians", "take it modulo a turn");
  }
  if (!(window.sweptRadians >= 0 && window.sweptRadians <= kMaxSweptTurns * 2 * kPi)) {
    fail("the window must hold between 0 and 16 turns", "shorten it");
  }
  if (!(window.fadeRadians >= 0 && std::isfinite(window.fadeRadians))) {
    fail("the fading must take 0 radians or more", "change it");
  }
}

/// What is left at the end of the window of the light of [from, to], on average.
double remaining(const SweepWindow& window, double from, double to) {
  if (window.fadeRadians == 0) {
    return 1;
  }
  const double newest = std::exp((to - window.endRadians) / window.fadeRadians);
  return newest * -std::expm1((from - to) / window.fadeRadians) * window.fadeRadians / (to - from);
}

}  // namespace

std::vector<ExposedArc> windowArcs(const DisplayProfile& profile, const SweepWindow& window, const Wobble& wobble) {
  validate(window);
  const double step = kPi / profile.slicesPerHalfTurn;
  const double least = step * 1e-9;  // below this an arc is rounding
  const double begin = window.endRadians - window.sweptRadians;
  const auto stepOf = [&](double angle) { return static_cast<int64_t>(std::floor(angle / step + 0.5)); };
  std::vector<ExposedArc> arcs;
  for (int64_t k = stepOf(begin); k <= stepOf(window.endRadians); ++k) {
    const double middle = static_cast<double>(k) * step;
    const double from = std::max(middle - step / 2, begin);
    const double to = std::min(middle + step / 2, window.endRadians);
    if (to - from > least) {
      const int64_t stored = profile.storedSlices();
      const auto slice = static_cast<int>((k % stored + stored) % stored);
      // The slices repeat after a half or a whole turn; the arc is that of the first one.
      const double back = middle - slice * step;
      const bool turned = stored == profile.slicesPerHalfTurn && (k - slice) / stored % 2 != 0;
      const ExposedArc whole{.slice = slice,
                             .fromRadians = from - back,
                             .toRadians = to - back,
                             .swingRadians = wobble.frequency * back + radiansFromDegrees(wobble.phaseDegrees)};
      for (ExposedArc arc : splitByChannel(profile, {whole})) {
        arc.passes = remaining(window, arc.fromRadians + back, arc.toRadians + back);
        arc.turnedPasses = turned ? arc.passes : 0;
        arcs.push_back(arc);
      }
    }
  }
  std::ranges::stable_sort(arcs, {}, [](const ExposedArc& arc) { return std::pair(arc.slice, arc.channels); });
  // Whole arcs come again with every turn: one does for all.
  const auto isAgain = [&](const ExposedArc& a, const ExposedArc& b) {
    return a.slice == b.slice && a.channels == b.channels && std::abs(a.fromRadians - b.fromRadians) < least &&
           std::abs(a.toRadians - b.toRadians) < least &&
           (wobble.amplitudeRadii == 0 ||
            std::abs(std::remainder(a.swingRadians - b.swingRadians, 2 * kPi)) < kSameSwing);
  };
  std::vector<ExposedArc> merged;
  for (const ExposedArc& arc : arcs) {
    if (!merged.empty() && isAgain(merged.back(), arc)) {
      merged.back().passes += arc.passes;
      merged.back().turnedPasses += arc.turnedPasses;
    } else {
      merged.push_back(arc);
    }
  }
  return merged;
}

}  // namespace ocelli
