#include "display_sim/gl/sweep_window.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void validate(const SweepWindow& window) {
  const auto fail = [](const std::string& what, const std::string& next) {
    throw InputError(what, "sweep window", next);
  };
  constexpr double kMostRadians = 1e6;  // beyond, angles lose their precision
  if (!(std::abs(window.endRadians) <= kMostRadians)) {
    fail("the screen's angle must lie within a million radians", "take it modulo a turn");
  }
  if (!(window.sweptRadians >= 0 && window.sweptRadians <= kMostSweptTurns * 2 * kPi)) {
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

std::vector<ExposedArc> windowArcs(const DisplayProfile& profile, const SweepWindow& window) {
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
      arcs.push_back({slice, from - back, to - back, remaining(window, from, to)});
    }
  }
  std::ranges::stable_sort(arcs, {}, &ExposedArc::slice);
  // Whole arcs come again with every turn: one does for all.
  std::vector<ExposedArc> merged;
  for (const ExposedArc& arc : arcs) {
    const bool again = !merged.empty() && merged.back().slice == arc.slice &&
                       std::abs(merged.back().fromRadians - arc.fromRadians) < least &&
                       std::abs(merged.back().toRadians - arc.toRadians) < least;
    if (again) {
      merged.back().passes += arc.passes;
    } else {
      merged.push_back(arc);
    }
  }
  return merged;
}

}  // namespace ocelli
