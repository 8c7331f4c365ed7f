#include "display_sim/observing/exposure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// In [0, period).
double wrapped(double angle, double period) {
  const double rest = std::fmod(angle, period);
  return rest < 0 ? rest + period : rest;
}

double sweptRadians(const DisplayProfile& profile, double seconds) {
  return profile.rotationsPerMinute / 60 * 2 * kPi * seconds;
}

/// Passes `first` to `first + count - 1`, counted from the one in which the screen passes the angle 0.
struct Passes {
  int64_t first = 0;
  int64_t count = 0;

  auto operator<=>(const Passes&) const = default;
};

/// Of a screen that starts and ends its sweep at other angles than `angle`.
Passes passesOf(const Sweep& sweep, double angle, double period) {
  const auto first = static_cast<int64_t>(std::ceil((sweep.fromRadians - angle) / period));
  const auto last = static_cast<int64_t>(std::floor((sweep.toRadians - angle) / period));
  return {first, last - first + 1};
}

bool isOdd(int64_t number) {
  return number % 2 != 0;
}

/// Passes that see the display at one phase of its wobble.
struct Swing {
  double radians = 0;
  double passes = 0;
  double turned = 0;
};

/// Sorts passes by the phase of the wobble.
class Swings {
 public:
  Swings(const DisplayProfile& profile, const Wobble& wobble, double period)
      : turns_(profile.secondHalfTurn == SecondHalfTurn::kMirrored), wobble_(wobble), period_(period) {}

  /// Most arcs of an exposure share their passes: they are sorted once.
  const std::vector<Swing>& of(const Passes& passes) {
    const auto [found, isNew] = known_.try_emplace(passes);
    if (isNew) {
      found->second = wobble_.amplitudeRadii > 0 ? sorted(passes) : steady(passes);
    }
    return found->second;
  }

 private:
  std::vector<Swing> steady(const Passes& passes) const {
    const int64_t end = passes.first + passes.count;
    // Of the numbers below n, n / 2, rounded down, are odd.
    const auto below = [](int64_t n) { return std::floor(static_cast<double>(n) / 2); };
    return {{0, static_cast<double>(passes.count), turns_ ? below(end) - below(passes.first) : 0}};
  }

  std::vector<Swing> sorted(const Passes& passes) const {
    constexpr double kFinest = 1 << 24;  // phases that differ by less than this part of a swing are rounding
    std::vector<Swing> swings = sorted(passes, kFinest);
    return swings.size() <= kMaxWobblePhases ? swings : sorted(passes, kMaxWobblePhases);
  }

  std::vector<Swing> sorted(const Passes& passes, double phases) const {
    std::map<int64_t, Swing> byPhase;
    for (int64_t pass = passes.first; pass < passes.first + passes.count; ++pass) {
      const double turns = wobble_.frequency * static_cast<double>(pass) * (period_ / (2 * kPi));
      const auto phase = static_cast<int64_t>(std::round(wrapped(turns, 1) * phases)) % static_cast<int64_t>(phases);
      Swing& swing = byPhase[phase];
      swing.radians = static_cast<double>(phase) / phases * 2 * kPi + radiansFromDegrees(wobble_.phaseDegrees);
      swing.passes += 1;
      swing.turned += turns_ && isOdd(pass) ? 1 : 0;
    }
    std::vector<Swing> swings;
    for (const auto& [phase, swing] : byPhase) {
      swings.push_back(swing);
    }
    return swings;
  }

  bool turns_;
  Wobble wobble_;
  double period_;
  std::map<Passes, std::vector<Swing>> known_;
};

}  // namespace

Sweep sweepEndingAt(const DisplayProfile& profile, double seconds, double endDegrees) {
  const double end = radiansFromDegrees(endDegrees);
  return {end - sweptRadians(profile, seconds), end};
}

Sweep sweepStartingAt(const DisplayProfile& profile, double seconds, double startDegrees) {
  const double start = radiansFromDegrees(startDegrees);
  return {start, start + sweptRadians(profile, seconds)};
}

std::vector<ExposedArc> exposedArcs(const DisplayProfile& profile, const Sweep& sweep, const Wobble& wobble) {
  const double step = kPi / profile.slicesPerHalfTurn;
  const double period = step * profile.storedSlices();
  // Below this an arc is rounding, as where the exposure is a whole number of refreshes.
  const double least = step * 1e-9;
  Swings swings(profile, wobble, period);

  std::vector<ExposedArc> arcs;
  for (int slice = 0; slice < profile.storedSlices(); ++slice) {
    const double from = (slice - 0.5) * step;
    // The arc is cut where the exposure begins and ends.
    std::vector<double> cuts = {0, step};
    for (const double cut : {wrapped(sweep.fromRadians - from, period), wrapped(sweep.toRadians - from, period)}) {
      if (cut < step) {
        cuts.push_back(cut);
      }
    }
    std::ranges::sort(cuts);
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i + 1] - cuts[i] <= least) {
        continue;
      }
      const Passes passes = passesOf(sweep, from + (cuts[i] + cuts[i + 1]) / 2, period);
      if (passes.count <= 0) {
        continue;
      }
      for (const Swing& swing : swings.of(passes)) {
        arcs.push_back(
            {slice, from + cuts[i], from + cuts[i + 1], swing.passes, swing.turned, kAllChannels, swing.radians});
      }
    }
  }
  return splitByChannel(profile, arcs);
}

std::vector<ExposedArc> splitByChannel(const DisplayProfile& profile, const std::vector<ExposedArc>& arcs) {
  if (profile.channelTiming == ChannelTiming::kTogether) {
    return arcs;
  }
  const double step = kPi / profile.slicesPerHalfTurn;
  std::vector<ExposedArc> split;
  for (const ExposedArc& arc : arcs) {
    for (int channel = 0; channel < 3; ++channel) {
      const double from = (arc.slice - 0.5 + channel / 3.0) * step;
      ExposedArc part = arc;
      part.fromRadians = std::max(arc.fromRadians, from);
      part.toRadians = std::min(arc.toRadians, from + step / 3);
      part.channels = 1u << channel;
      if (part.toRadians - part.fromRadians > step * 1e-9) {
        split.push_back(part);
      }
    }
  }
  return split;
}

}  // namespace ocelli
