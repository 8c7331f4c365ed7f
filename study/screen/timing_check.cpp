#include "study/screen/timing_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "oc_core/base/json_fields.h"
#include "study/outline/run_fields.h"

namespace ocelli {
namespace {

constexpr double kMaxOfScreenHertz = 1.5;  // faster than that are only frames that wait for nothing
constexpr int kMinIntervals = 30;

bool agrees(double hertz, double expected, double tolerance) {
  return std::abs(hertz - expected) <= tolerance * expected;
}

std::string percent(double share) {
  return fmt::format("{:.1f} %", 100 * share);
}

std::string rateText(double hertz) {
  return hertz >= 1000 ? fmt::format("{:.1f} kHz", hertz / 1000) : fmt::format("{:.2f} Hz", hertz);
}

}  // namespace

TimingMeasurement measureTiming(std::span<const int64_t> shownNanoseconds, double lateFactor) {
  TimingMeasurement measured;
  std::vector<double> intervals;  // nanoseconds
  for (size_t i = 1; i < shownNanoseconds.size(); ++i) {
    intervals.push_back(static_cast<double>(shownNanoseconds[i] - shownNanoseconds[i - 1]));
  }
  if (intervals.empty()) {
    return measured;
  }
  measured.intervals = static_cast<int>(intervals.size());
  measured.seconds = static_cast<double>(shownNanoseconds.back() - shownNanoseconds.front()) / 1e9;
  measured.longestMilliseconds = *std::ranges::max_element(intervals) / 1e6;
  std::vector<double> sorted = intervals;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  const double latest = lateFactor * *middle;
  double sum = 0;
  double squares = 0;
  int onTime = 0;
  for (const double interval : intervals) {
    if (interval <= latest) {
      sum += interval;
      ++onTime;
    }
  }
  const double mean = onTime > 0 ? sum / onTime : 0;
  for (const double interval : intervals) {
    if (interval <= latest) {
      squares += (interval - mean) * (interval - mean);
    }
  }
  measured.lateShare = (measured.intervals - onTime) / static_cast<double>(measured.intervals);
  if (mean > 0) {
    measured.hertz = 1e9 / mean;
    measured.jitterShare = std::sqrt(squares / onTime) / mean;
  }
  return measured;
}

TimingCheck checkTiming(const TimingMeasurement& measured, const TimingExpectation& expected) {
  TimingCheck check{measured, expected};
  const TimingLimits& limits = expected.limits;
  const double screenHertz = expected.monitorHertz > 0 ? expected.monitorHertz : expected.wantedHertz.value_or(0);
  check.verticalSync = measured.hertz > 0 && measured.hertz <= kMaxOfScreenHertz * screenHertz;
  if (measured.intervals < kMinIntervals) {
    check.problems.push_back(fmt::format("only {} frames were shown in the time of the check", measured.intervals + 1));
    check.advice.push_back("close other programs; use the graphics driver of the maker of the graphics card");
    return check;
  }
  if (screenHertz <= 0) {
    check.problems.push_back(fmt::format(
        "the screen does not say how often it shows a frame, and {} were shown a second: whether they wait for it "
        "cannot be told",
        rateText(measured.hertz)));
    check.advice.push_back(
        "use a real monitor (virtual screens have no rate), or give \"refresh_hertz\" in the field \"screen\" of the "
        "protocol");
    return check;
  }
  if (!check.verticalSync) {
    check.problems.push_back(fmt::format(
        "frames do not wait for the screen: {} were shown a second, so when each of them is seen is not known",
        rateText(measured.hertz)));
    check.advice.push_back(
        "turn vertical synchronisation on in the settings of the graphics driver (vblank_mode=1 with Mesa, \"Sync to "
        "VBlank\" with NVIDIA); virtual screens have none");
    return check;
  }
  if (expected.monitorHertz > 0 && !agrees(measured.hertz, expected.monitorHertz, limits.refreshTolerance)) {
    check.problems.push_back(
        fmt::format("the monitor says {} Hz, but frames come at {}", expected.monitorHertz, rateText(measured.hertz)));
    check.advice.push_back(
        "choose the monitor that shows the window (--monitor), switch variable refresh rates (FreeSync, G-SYNC) and "
        "desktop effects off, and use one monitor alone");
  }
  if (expected.wantedHertz && !agrees(measured.hertz, *expected.wantedHertz, limits.refreshTolerance)) {
    check.problems.push_back(fmt::format("the protocol wants {} Hz, but frames come at {}", *expected.wantedHertz,
                                         rateText(measured.hertz)));
    check.advice.push_back("set the monitor to the protocol's rate (xrandr --output NAME --rate HZ)");
  }
  if (measured.jitterShare > limits.maxJitterShare) {
    check.problems.push_back(
        fmt::format("frames come unevenly: the intervals between them differ by {}, at most {} are allowed",
                    percent(measured.jitterShare), percent(limits.maxJitterShare)));
  }
  if (measured.lateShare > limits.maxDroppedShare) {
    check.problems.push_back(fmt::format("{} of the frames come late, at most {} may", percent(measured.lateShare),
                                         percent(limits.maxDroppedShare)));
  }
  if (measured.jitterShare > limits.maxJitterShare || measured.lateShare > limits.maxDroppedShare) {
    check.advice.push_back(
        "close other programs, switch desktop effects and power saving off, and use full screen instead of --windowed");
  }
  return check;
}

std::string describe(const TimingMeasurement& measured) {
  return fmt::format("measured {}, jitter {}, late {} of {} frames, longest {:.1f} ms", rateText(measured.hertz),
                     percent(measured.jitterShare), percent(measured.lateShare), measured.intervals,
                     measured.longestMilliseconds);
}

std::string jsonText(const TimingCheck& check) {
  using Json = nlohmann::ordered_json;
  const TimingMeasurement& measured = check.measured;
  const TimingExpectation& expected = check.expected;
  const Json json = {{run_fields::kVerdict, check.isGood() ? "good" : "refused"},
                     {"problems", check.problems},
                     {"vertical_sync", check.verticalSync},
                     {run_fields::kMeasured,
                      {{"intervals", measured.intervals},
                       {"seconds", measured.seconds},
                       {run_fields::kHertz, measured.hertz},
                       {run_fields::kJitterShare, measured.jitterShare},
                       {run_fields::kLateShare, measured.lateShare},
                       {"longest_milliseconds", measured.longestMilliseconds}}},
                     {"expected",
                      {{"monitor_hertz", expected.monitorHertz > 0 ? Json(expected.monitorHertz) : Json()},
                       {"protocol_hertz", expected.wantedHertz ? Json(*expected.wantedHertz) : Json()},
                       {"late_factor", expected.limits.lateFactor},
                       {"most_dropped_share", expected.limits.maxDroppedShare},
                       {"most_jitter_share", expected.limits.maxJitterShare},
                       {"refresh_tolerance", expected.limits.refreshTolerance}}}};
  return textOfJson(json);
}

double refreshRateOf(const TimingCheck& check) {
  const int monitor = check.expected.monitorHertz;
  if (monitor > 0 && agrees(check.measured.hertz, monitor, check.expected.limits.refreshTolerance)) {
    return monitor;
  }
  return std::round(100 * check.measured.hertz) / 100;
}

}  // namespace ocelli
