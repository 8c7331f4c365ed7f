#include "oc_core/window/frame_pacer.h"

#include <algorithm>

namespace ocelli {
namespace {

constexpr double kDefaultRate = 60;
// Screens are a little faster or slower than they say. Who waits for the full period would miss one of them sometimes.
constexpr double kShareOfPeriod = 0.95;

}  // namespace

FramePacer::FramePacer(double refreshRate)
    : period_(refreshRate > 0 ? kShareOfPeriod / refreshRate : 1 / kDefaultRate) {}

double FramePacer::wait(double now) {
  const double wait = started_ ? std::clamp(due_ - now, 0.0, period_) : 0;
  started_ = true;
  due_ = now + wait + period_;
  return wait;
}

}  // namespace ocelli
