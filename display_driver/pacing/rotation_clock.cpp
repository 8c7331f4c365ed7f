#include "display_driver/pacing/rotation_clock.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Standard deviations: of the rate after a second, and of a refresh's length; shares of themselves.
constexpr double kRateWander = 1e-3;
constexpr double kLengthJitter = 1e-3;
/// Of a first reading, in refreshes, and of the rate that it tells.
constexpr double kFirstJitter = 0.02;
constexpr double kFirstRateError = 0.01;
/// The clock never believes that readings are better than this, in refreshes: a hundredth of a slice, about.
constexpr double kMinJitter = 1e-4;
constexpr double kMaxJitter = 0.1;
/// Readings this many standard deviations off are left out, until so many have come in a row.
constexpr double kUnlikely = 6;
constexpr int kMaxUnlikely = 4;
/// What a reading counts for in the estimate of their jitter.
constexpr double kLearning = 0.05;

double squared(double x) {
  return x * x;
}

}  // namespace

RotationClock::RotationClock(double refreshSeconds) : idealRate_(1 / refreshSeconds), rate_(idealRate_) {
  OC_CHECK(refreshSeconds > 0, "a refresh takes some time");
}

double RotationClock::secondsSince(HostTime time) const {
  return std::chrono::duration<double>(time - time_).count();
}

void RotationClock::begin(const RotationReading& reading) {
  running_ = true;
  time_ = reading.time;
  base_ = reading.refresh;
  refreshes_ = reading.share;
  rate_ = reading.refreshSeconds > 0 ? 1 / reading.refreshSeconds : idealRate_;
  covariance_ = {squared(kFirstJitter), 0, squared(kFirstRateError * rate_)};
  readingVariance_ = squared(kFirstJitter);
  unlikely_ = 0;
}

RotationClock::Covariance RotationClock::ahead(double seconds) const {
  const double t = std::abs(seconds);
  const double wander = squared(kRateWander * rate_);
  return {covariance_.pp + 2 * t * covariance_.pr + t * t * covariance_.rr + wander * t * t * t / 3 +
              squared(kLengthJitter) * rate_ * t,
          covariance_.pr + t * covariance_.rr + wander * t * t / 2, covariance_.rr + wander * t};
}

void RotationClock::add(const RotationReading& reading) {
  if (!running_) {
    begin(reading);
    heard_ = reading.time;
    return;
  }
  if (reading.time <= heard_) {
    return;
  }
  heard_ = reading.time;
  const double seconds = secondsSince(reading.time);
  const Covariance predicted = ahead(seconds);
  const double difference = static_cast<double>(static_cast<int64_t>(reading.refresh - base_)) + reading.share -
                            (refreshes_ + rate_ * seconds);
  const double variance = predicted.pp + readingVariance_;
  if (!(squared(difference) <= squared(kUnlikely) * variance)) {
    if (++unlikely_ == kMaxUnlikely) {
      begin(reading);
      ++restarts_;
    }
    return;
  }
  unlikely_ = 0;
  const double phaseGain = predicted.pp / variance;
  const double rateGain = predicted.pr / variance;
  time_ = reading.time;
  refreshes_ += rate_ * seconds + phaseGain * difference;
  // A rate far from the display's comes from readings that make no sense.
  rate_ = std::clamp(rate_ + rateGain * difference, 0.1 * idealRate_, 10 * idealRate_);
  covariance_ = {(1 - phaseGain) * predicted.pp, (1 - phaseGain) * predicted.pr,
                 predicted.rr - rateGain * predicted.pr};
  const double seen = std::max(squared(difference) - predicted.pp, 0.0);
  readingVariance_ =
      std::clamp((1 - kLearning) * readingVariance_ + kLearning * seen, squared(kMinJitter), squared(kMaxJitter));
}

double RotationClock::refreshesAt(HostTime time) const {
  OC_CHECK(running_, "nothing is known of the rotation");
  return std::max(0.0, static_cast<double>(base_) + (refreshes_ + rate_ * secondsSince(time)));
}

HostTime RotationClock::timeOf(double refreshes) const {
  OC_CHECK(running_, "nothing is known of the rotation");
  const double seconds = ((refreshes - static_cast<double>(base_)) - refreshes_) / rate_;
  return time_ + std::chrono::nanoseconds(std::llround(std::clamp(seconds, -1e9, 1e9) * 1e9));
}

uint64_t RotationClock::refreshAfter(HostTime time) const {
  auto refresh = static_cast<uint64_t>(std::ceil(refreshesAt(time)));
  // To the nanosecond, as beginOf() says it.
  while (refresh > 0 && beginOf(refresh - 1) >= time) {
    --refresh;
  }
  while (beginOf(refresh) < time) {
    ++refresh;
  }
  return refresh;
}

double RotationClock::uncertaintySeconds(HostTime time) const {
  return std::sqrt(ahead(secondsSince(time)).pp) / rate_;
}

}  // namespace ocelli
