#include "display_driver/pacing/foreseen_eyes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

using Seconds = std::chrono::duration<double>;

/// Where the tracker's clock seems to have jumped by more than this, times are those of arrival again.
constexpr Seconds kMaxJump{0.5};
/// How fast the shortest delay known is forgotten, so that clocks may drift apart: seconds a second.
constexpr double kForget = 1e-3;
/// What nothing was ever heard about is not waited for.
constexpr size_t kMaxOpen = 64;
/// A day at 24 Hz.
constexpr size_t kMaxErrors = 2'000'000;

double quantile(std::vector<float> values, double share) {
  if (values.empty()) {
    return 0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return static_cast<double>(*at);
}

}  // namespace

/// When the pose was, by the host's clock. Lines come with delays that vary; the least of them is taken as none.
HostTime ForeseenEyes::timeOf(const EyePose& pose, HostTime arrival) {
  const Seconds offset = Seconds(arrival.time_since_epoch()) - Seconds(pose.seconds);
  const bool goesForward = lastTold_ && pose.seconds > *lastTold_;
  const double step = goesForward ? pose.seconds - *lastTold_ : 0;
  lastTold_ = pose.seconds;
  if (!goesForward || !offset_ || std::abs((offset - *offset_).count()) > kMaxJump.count()) {
    offset_ = offset;
    return arrival;
  }
  offset_ = std::min(offset, *offset_ + Seconds(step * kForget));
  return HostTime(std::chrono::duration_cast<HostTime::duration>(Seconds(pose.seconds) + *offset_));
}

void ForeseenEyes::add(const EyePose& pose, HostTime arrival) {
  const HostTime time = timeOf(pose, arrival);
  predictor_.add(time, pose.eye);
  while (last_ && !open_.empty() && open_.front().place.time <= time) {
    const Foreseen foreseen = open_.front();
    open_.pop_front();
    if (foreseen.place.time <= last_->time || off_.size() >= kMaxErrors) {
      continue;
    }
    const double share = Seconds(foreseen.place.time - last_->time) / Seconds(time - last_->time);
    const glm::vec3 eye = last_->eye + (pose.eye - last_->eye) * static_cast<float>(share);
    off_.push_back(glm::distance(foreseen.place.eye, eye));
    offLast_.push_back(glm::distance(foreseen.last.eye, eye));
    ahead_.push_back(static_cast<float>(Seconds(foreseen.place.time - foreseen.last.time).count()));
  }
  last_ = Place{time, pose.eye};
}

std::optional<glm::vec3> ForeseenEyes::at(HostTime seen) {
  const std::optional<glm::vec3> eye = predictor_.at(seen);
  if (eye && last_ && seen > last_->time) {
    open_.push_back({{seen, *eye}, *last_});
    if (open_.size() > kMaxOpen) {
      open_.pop_front();
    }
  }
  return eye;
}

PredictionErrors ForeseenEyes::errors() const {
  return {off_.size(),
          quantile(off_, 0.5),
          quantile(off_, 0.95),
          quantile(offLast_, 0.5),
          quantile(offLast_, 0.95),
          quantile(ahead_, 0.5)};
}

}  // namespace ocelli
