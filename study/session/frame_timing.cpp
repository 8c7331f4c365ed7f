#include "study/session/frame_timing.h"

#include <algorithm>

namespace ocelli {

TrialTiming timingOf(std::span<const int64_t> shownNanoseconds, const TimingLimits& limits, const FrameClock& clock) {
  TrialTiming timing;
  timing.frames = static_cast<int64_t>(shownNanoseconds.size());
  std::vector<int64_t> intervals;
  for (size_t i = 1; i < shownNanoseconds.size(); ++i) {
    intervals.push_back(shownNanoseconds[i] - shownNanoseconds[i - 1]);
  }
  const double late = limits.lateFactor * static_cast<double>(clock.intervalNanoseconds);
  timing.dropped = std::count_if(intervals.begin(), intervals.end(),
                                 [&](int64_t interval) { return static_cast<double>(interval) > late; });
  if (!intervals.empty()) {
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    timing.medianNanoseconds = *middle;
    timing.longestNanoseconds = *std::max_element(intervals.begin(), intervals.end());
  }
  const bool manyDropped =
      static_cast<double>(timing.dropped) > limits.maxDroppedShare * static_cast<double>(timing.frames);
  // They did not wait for the screen, so that what is counted in frames was too short.
  const bool early = timing.medianNanoseconds > 0 && static_cast<double>(timing.medianNanoseconds) * limits.lateFactor <
                                                         static_cast<double>(clock.intervalNanoseconds);
  timing.verdict = clock.simulated  ? TimingVerdict::kSimulatedClock
                   : clock.unstable ? TimingVerdict::kUnstableRefresh
                   : early          ? TimingVerdict::kEarlyFrames
                   : manyDropped    ? TimingVerdict::kDroppedFrames
                                    : TimingVerdict::kGood;
  return timing;
}

}  // namespace ocelli
