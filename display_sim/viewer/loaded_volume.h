// A volume that the viewer shows, and what its panels tell of it.
#pragma once

#include "oc_core/volume/volume_histogram.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct LoadedVolume {
  VolumeScene scene;
  VolumeHistogram histogram;
};

}  // namespace ocelli
