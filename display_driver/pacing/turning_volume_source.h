// A volume of scalars that turns about the display's axis, whose transfer function moves, or that is another one later
// (a time series), sliced anew for each refresh.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "display_driver/pacing/volume_source.h"
#include "display_sim/volume_slicing/volume_slicer.h"

namespace ocelli {

/// What is shown at a moment: the same pointers stand for the same look.
struct VolumeMoment {
  const SweptSamples* samples = nullptr;
  std::shared_ptr<const SweptLight> light{};
};

/// Seconds since the first refresh; nothing where it has ended.
using VolumeMoments = std::function<std::optional<VolumeMoment>(double seconds)>;

class TurningVolumeSource final : public VolumeSource {
 public:
  /// The samples of all moments are of `profile`, and must outlive it. Positive degrees turn them counter-clockwise
  /// seen from above, in steps of the display's sweep.
  TurningVolumeSource(VolumeMoments moments, const DisplayProfile& profile, const SliceOptions& options,
                      double degreesPerSecond);

  SourcedVolume volumeFor(HostTime seen) override;

 private:
  VolumeMoments moments_;
  SweepGeometry sweep_;
  VolumeSlicer slicer_;
  double radiansPerSecond_;
  std::optional<HostTime> start_;
  VolumeMoment shown_;  ///< last, turned by so many steps
  int steps_ = 0;
};

}  // namespace ocelli
