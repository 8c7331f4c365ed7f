// Whether a screen is steady enough for a study: measured before the subject sits down, from the times at which frames
// were shown.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

struct TimingMeasurement {
  int intervals = 0;       ///< between frames
  double seconds = 0;      ///< from the first frame to the last
  double hertz = 0;        ///< from the mean of the intervals that are not late; 0 where there are none
  double jitterShare = 0;  ///< standard deviation of these, of their mean
  double lateShare = 0;    ///< intervals of more than the median times the factor of the limits
  double longestMilliseconds = 0;
};

/// `lateFactor` as in TimingLimits.
TimingMeasurement measureTiming(std::span<const int64_t> shownNanoseconds, double lateFactor);

/// What the screen should be like.
struct TimingExpectation {
  int monitorHertz = 0;                 ///< as the monitor says, rounded; 0 where it does not
  std::optional<double> wantedHertz{};  ///< by the protocol
  TimingLimits limits{};
};

struct TimingCheck {
  TimingMeasurement measured;
  TimingExpectation expected;
  bool verticalSync = false;            ///< frames wait for the screen
  std::vector<std::string> problems{};  ///< what is wrong, a sentence each; none where sessions may run
  std::vector<std::string> advice{};    ///< what to try

  bool isGood() const { return problems.empty(); }
};

TimingCheck checkTiming(const TimingMeasurement& measured, const TimingExpectation& expected);

/// "measured 59.95 Hz, jitter 0.4 %, late 0.0 % of 150 frames, longest 16.9 ms".
std::string describe(const TimingMeasurement& measured);
/// For the database.
std::string jsonText(const TimingCheck& check);

/// The rate that trials count their frames by: what the monitor says where that is what it does, which is the same for
/// every session; else what was measured.
double refreshRateOf(const TimingCheck& check);

}  // namespace ocelli
