#include "display_driver/pacing/turning_volume_source.h"

#include <utility>

#include "oc_core/base/conventions.h"

namespace ocelli {

TurningVolumeSource::TurningVolumeSource(const SweptSamples& samples, SweptLight still, MovingLight light,
                                         const SliceOptions& options, double degreesPerSecond)
    : samples_(samples),
      still_(std::move(still)),
      light_(std::move(light)),
      slicer_(samples.profile(), options),
      radiansPerSecond_(radiansFromDegrees(degreesPerSecond)) {}

SourcedVolume TurningVolumeSource::volumeFor(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const double seconds = std::chrono::duration<double>(seen - *start_).count();
  const int steps = stepsOfAngle(samples_.sweep(), radiansPerSecond_ * seconds);
  if (!light_ && steps_ == steps) {
    return {.kind = SourcedVolume::Kind::kSame};
  }
  steps_ = steps;
  slicer_.slice(samples_, light_ ? light_(seconds) : still_, steps);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
