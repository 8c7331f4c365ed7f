// Volumes that are made: `builtin:volume,name=NAME[,size=VOXELS]`.
#pragma once

#include <string>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct BuiltinVolume {
  ScalarVolume volume;
  VolumeAppearance appearance;  ///< unless the user says another
};

bool isBuiltinVolume(const std::string& source);

/// Throws InputError for a name or a number that is wrong.
BuiltinVolume makeBuiltinVolume(const std::string& source);

}  // namespace ocelli
