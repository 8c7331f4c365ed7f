#include "display_driver/pacing/turning_volume_source.h"

#include <utility>

#include "oc_core/base/conventions.h"

namespace ocelli {

TurningVolumeSource::TurningVolumeSource(VolumeMoments moments, const DisplayProfile& profile,
                                         const SliceOptions& options, double degreesPerSecond)
    : moments_(std::move(moments)),
      sweep_(profile),
      slicer_(profile, options),
      radiansPerSecond_(radiansFromDegrees(degreesPerSecond)) {}

SourcedVolume TurningVolumeSource::volumeFor(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const double seconds = std::chrono::duration<double>(seen - *start_).count();
  std::optional<VolumeMoment> moment = moments_(seconds);
  if (!moment) {
    return {.kind = SourcedVolume::Kind::kEnd};
  }
  const int steps = stepsOfAngle(sweep_, radiansPerSecond_ * seconds);
  if (moment->samples == shown_.samples && moment->light == shown_.light && steps == steps_) {
    return {.kind = SourcedVolume::Kind::kSame};
  }
  shown_ = std::move(*moment);
  steps_ = steps;
  slicer_.slice(*shown_.samples, *shown_.light, steps);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
