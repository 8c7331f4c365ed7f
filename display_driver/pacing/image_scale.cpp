#include "display_driver/pacing/image_scale.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ocelli {
namespace {

/// Four steps halve the number of pixels each way.
constexpr double kStep = 0.8408964152537145;
/// Time grows with this power of the pixels each way: more than with some parts of the work, which do not depend on
/// them, and less than with the pixels.
constexpr double kGrowth = 1.5;
/// The same at its worst, for who tries one step after the other.
constexpr double kFastestGrowth = 2;
/// Of the time that there is, what a larger image may be expected to take.
constexpr double kRoomToGrow = 0.9;
/// Images in time before a step up; twice as many each time that it was a step too far.
constexpr int kPatience = 6;
constexpr int kMaxPatience = 192;
/// Images after a late one during which another late one means that it was no hiccup.
constexpr int kWatched = 6;

double stepUp(double scale) {
  const double larger = scale / kStep;
  // Steps of 1/1000 hide rounding: four up and four down meet, and eight up end at the whole.
  return larger > 0.99 ? 1 : std::round(larger * 1000) / 1000;
}

}  // namespace

ImageScale::ImageScale(double seconds, double minScale)
    : seconds_(seconds), minScale_(minScale), scale_(minScale), patience_(kPatience) {}

void ImageScale::add(double scale, double seconds) {
  if (seconds > seconds_) {
    const bool isHiccup = watched_ == 0 && !starting_;
    watched_ = kWatched;
    if (!isHiccup) {
      shrink(scale, seconds);
    }
    starting_ = false;
    return;
  }
  watched_ = std::max(watched_ - 1, 0);
  // One of before it grew, or shrank, says nothing of the scale now.
  if (scale != scale_ || scale_ >= 1) {
    return;
  }
  times_.add(std::chrono::duration_cast<StageTimes::Duration>(std::chrono::duration<double>(seconds)));
  ++inTime_;
  const double factor = std::pow(stepUp(scale_) / scale_, starting_ ? kFastestGrowth : kGrowth);
  const double expected = std::chrono::duration<double>(times_.median()).count() * factor;
  if (inTime_ >= (starting_ ? 1 : patience_) && expected <= kRoomToGrow * seconds_) {
    grow();
  }
}

void ImageScale::shrink(double scale, double seconds) {
  double smaller = scale;
  while (seconds > seconds_ && smaller > minScale_) {
    // In whole steps, so that few sizes are in use.
    smaller *= kStep;
    seconds *= std::pow(kStep, kGrowth);
  }
  smaller = std::max(smaller, minScale_);
  if (smaller < scale_) {
    scale_ = smaller;
    patience_ = std::min(2 * patience_, kMaxPatience);
    times_ = {};
    inTime_ = 0;
  }
}

void ImageScale::grow() {
  scale_ = stepUp(scale_);
  times_ = {};
  inTime_ = 0;
}

}  // namespace ocelli
