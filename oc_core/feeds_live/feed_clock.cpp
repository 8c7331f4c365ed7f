#include "oc_core/feeds_live/feed_clock.h"

#include <algorithm>

namespace ocelli {
namespace {

/// By how much clocks of cameras run differently, at most: 1 s a quarter of an hour.
constexpr double kDriftPerSecond = 1e-3;
constexpr double kJumpSeconds = 5;  ///< timestamps that go back so far, or on, begin anew

}  // namespace

double FeedClock::placeSeconds(double stamp, double now) {
  if (kind_ == Kind::kRecorded) {
    return stamp;
  }
  const double offset = now - stamp;
  const double passed = stamp - lastStamp_;
  const bool isAnew = !offset_ || passed < -kJumpSeconds || offset < *offset_ - kJumpSeconds;
  if (isAnew) {
    offset_ = offset;
  } else if (kind_ == Kind::kLive) {
    offset_ = std::min(offset, *offset_ + kDriftPerSecond * std::max(passed, 0.0));
  }
  lastStamp_ = stamp;
  return stamp + *offset_;
}

}  // namespace ocelli
