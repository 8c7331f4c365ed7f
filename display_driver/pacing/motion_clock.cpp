#include "display_driver/pacing/motion_clock.h"

#include <chrono>

#include "oc_core/scene/moving_scene.h"

namespace ocelli {

std::optional<double> MotionClock::at(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const double seconds = playback_.speed * std::chrono::duration<double>(seen - *start_).count();
  if (!playback_.loop && seconds >= durationSeconds_) {
    return std::nullopt;
  }
  return timeInMotion(seconds, durationSeconds_, playback_.loop);
}

}  // namespace ocelli
