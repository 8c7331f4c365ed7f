#include "display_driver/pacing/image_scale.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

/// Four steps halve the number of pixels each way.
constexpr double kStep = 0.8408964152537145;
/// Time grows with this power of the pixels each way: more than with some parts of the work, which do not depend on
/// them, and less than with the pixels.
constexpr double kGrowth = 1.5;
/// Of the time that there is, what a larger image may be expected to take.
constexpr double kRoomToGrow = 0.9;
/// What must have been in time in a row for the image to grow by a step.
constexpr int kToGrow = 6;
/// Images after a late one during which another late one means that it was no hiccup.
constexpr int kWatched = 4;

}  // namespace

ImageScale::ImageScale(double seconds, double minScale) : seconds_(seconds), minScale_(minScale) {}

void ImageScale::add(double scale, double seconds) {
  if (seconds > seconds_) {
    // In whole steps, so that few sizes are in use. One late image alone may be a hiccup, and costs a step.
    double smaller = scale;
    double expected = seconds;
    const bool isHiccup = watched_ == 0;
    while (expected > seconds_ && smaller > minScale_) {
      smaller *= kStep;
      expected = isHiccup ? 0 : expected * std::pow(kStep, kGrowth);
    }
    scale_ = std::max(std::min(scale_, smaller), minScale_);
    inTime_ = 0;
    watched_ = kWatched;
    return;
  }
  watched_ = std::max(watched_ - 1, 0);
  // One of before it grew, or shrank, says nothing of the scale now.
  if (scale != scale_ || scale_ >= 1) {
    return;
  }
  const double larger = std::min(scale_ / kStep, 1.0);
  // Here at its worst: as the number of pixels.
  const double expected = seconds * (larger / scale_) * (larger / scale_);
  inTime_ = expected <= kRoomToGrow * seconds_ ? inTime_ + 1 : 0;
  if (inTime_ >= kToGrow) {
    // Steps of 1/1000 hide rounding: four up and four down meet.
    scale_ = std::min(std::round(larger * 1000) / 1000, 1.0);
    inTime_ = 0;
  }
}

}  // namespace ocelli
