#include "study/session/running_trial.h"

#include <algorithm>

namespace ocelli {
namespace {

constexpr int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr int64_t kHandOverEvery = kNanosecondsPerSecond / 2;

}  // namespace

int64_t RunningTrial::tickAt(int64_t nanoseconds) const {
  if (shown_.empty() || nanoseconds <= shown_.front()) {
    return 0;
  }
  // Whole seconds first: a product of all nanoseconds would overflow after years.
  const int64_t since = nanoseconds - shown_.front();
  return since / kNanosecondsPerSecond * kTicksPerSecond +
         since % kNanosecondsPerSecond * kTicksPerSecond / kNanosecondsPerSecond;
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
  run_->frameShown();
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
}

}  // namespace ocelli
