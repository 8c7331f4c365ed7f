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
  // The next frame is expected after the interval of the screen, or after that of the frames so far where these come
  // slower. It is the first without the scene where the end of the time is nearer to it than to the frame after it.
  const auto now = static_cast<double>(tick);
  const double interval = std::max(intervalTicks_, frames_ > 0 ? now / static_cast<double>(frames_) : 0);
  ++frames_;
  over_ = rule_ == ExposureRule::kFrames ? frames_ >= maxFrames_ : now + 1.5 * interval >= endTick_;
}

}  // namespace ocelli
