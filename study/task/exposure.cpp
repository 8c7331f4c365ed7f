#include "study/task/exposure.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

Exposure::Exposure(ExposureRule rule, double seconds, double refreshHertz)
    : rule_(rule),
      endTick_(seconds * static_cast<double>(kTicksPerSecond)),
      intervalTicks_(static_cast<double>(kTicksPerSecond) / refreshHertz),
      maxFrames_(std::max<int64_t>(1, std::llround(seconds * refreshHertz))) {}

void Exposure::frameShown(int64_t tick) {
  if (over_) {
    if (!shownTicks_ && rule_ == ExposureRule::kClock) {
      shownTicks_ = tick;
    }
    return;
  }
  // The next frame is expected after the interval of the screen, or after the shorter of the last two where frames come
  // slower: one late frame alone tells nothing of the next. It is the first without the scene where it comes at the end
  // of the time or, by half an interval of the screen, before it.
  const int64_t last = tick - lastTick_;
  const double interval = std::max(intervalTicks_, frames_ > 1 ? static_cast<double>(std::min(last, before_)) : 0);
  before_ = last;
  lastTick_ = tick;
  ++frames_;
  over_ = rule_ == ExposureRule::kFrames ? frames_ >= maxFrames_
                                         : static_cast<double>(tick) + interval >= endTick_ - intervalTicks_ / 2;
}

}  // namespace ocelli
