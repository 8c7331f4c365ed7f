// What constructors of graph and curved ray cameras (oc_core/constructor) know of a volume: its box, which stands for
// its structure, and the surfaces in it, which are object 1. It has no portals, path, target or maze of its own, and
// nowhere to walk: cameras that need some take them from their files.
#pragma once

#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

inline constexpr uint32_t kSurfacesObject = 1;

GuidedScene guidedVolume(const VolumeScene& scene);

}  // namespace ocelli
