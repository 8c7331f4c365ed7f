#include "study/session/running_trial.h"

#include <algorithm>

namespace ocelli {
namespace {

constexpr int64_t kHandOverEvery = 500'000'000;  // nanoseconds

}  // namespace

int64_t RunningTrial::tickAt(int64_t nanoseconds) const {
  return shown_.empty() ? 0 : ticksBetween(shown_.front(), nanoseconds);
}

void RunningTrial::advanceTo(int64_t tick) {
  for (; tick_ < tick && !isOver(); ++tick_) {
    run_->advance();
  }
}

void RunningTrial::update(int64_t now) {
  advanceTo(tickAt(now));
  if (now - handedOver_ >= kHandOverEvery) {
    handOver();
    handedOver_ = now;
  }
}

bool RunningTrial::take(const TimedInput& input, int64_t now) {
  const int64_t tick = std::max({tickAt(input.nanoseconds), tick_, lastShownTick_ + 1});
  if (tick > tickAt(now)) {
    return false;
  }
  advanceTo(tick);
  if (isOver()) {
    return false;
  }
  run_->handle(input.event);
  inputs_.push_back({input.nanoseconds, tick, input.event});
  return true;
}

void RunningTrial::frameShown(int64_t nanoseconds, std::optional<uint64_t> pixelHash) {
  frames_.push_back({nextFrame(), tick_, nanoseconds, run_->pose(), pixelHash});
  shown_.push_back(nanoseconds);
  lastShownTick_ = tick_;
  run_->frameShown(tickAt(nanoseconds));
}

void RunningTrial::takeGaze(std::span<const GazeRecord> samples) {
  for (const GazeRecord& sample : samples) {
    if (!shown_.empty() && sample.nanoseconds >= shown_.front()) {
      gaze_.push_back(sample);
    }
  }
}

void RunningTrial::handOver() {
  if (!frames_.empty()) {
    sink_.frames(number_, frames_);
    frames_.clear();
  }
  if (!inputs_.empty()) {
    sink_.inputs(number_, inputs_);
    inputs_.clear();
  }
  if (!gaze_.empty()) {
    sink_.gaze(number_, gaze_);
    gaze_.clear();
  }
}

}  // namespace ocelli
