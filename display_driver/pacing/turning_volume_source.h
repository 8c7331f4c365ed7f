// A volume of scalars that turns about the display's axis, or whose transfer function moves, sliced anew for each
// refresh.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "display_driver/pacing/volume_source.h"
#include "display_sim/volume_slicing/volume_slicer.h"

namespace ocelli {

/// The light of a volume so many seconds after the first refresh.
using MovingLight = std::function<SweptLight(double seconds)>;

class TurningVolumeSource final : public VolumeSource {
 public:
  /// `samples` must outlive it. Positive degrees turn it counter-clockwise seen from above, in steps of the display's
  /// sweep. Without `light` that of `still` stays.
  TurningVolumeSource(const SweptSamples& samples, SweptLight still, MovingLight light, const SliceOptions& options,
                      double degreesPerSecond);

  SourcedVolume volumeFor(HostTime seen) override;

 private:
  const SweptSamples& samples_;
  SweptLight still_;
  MovingLight light_;
  VolumeSlicer slicer_;
  double radiansPerSecond_;
  std::optional<HostTime> start_;
  std::optional<int> steps_;  ///< of the last volume
};

}  // namespace ocelli
