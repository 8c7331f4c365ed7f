// A volume as Python has it: one moment of its voxels' series, and what they look like in a scene.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "oc_core/volume/volume_scene.h"
#include "oc_core/volume/volume_series.h"

namespace ocelli {

struct PythonVolume {
  std::shared_ptr<const VolumeSeries> series;
  size_t index = 0;
  VolumeScene scene;

  const ScalarVolume& whole() const { return *series->volumes[index]; }
  const std::string& source() const { return series->source; }
};

/// The opacity at which a ray hits something, as `ocelli ocri build --opacity` takes it. Throws InputError out of
/// range.
double depthOpacityOf(std::optional<double> wanted);

}  // namespace ocelli
