// Volumes that are made by code: `builtin:volume,name=NAME[,key=value...]`.
//
// Recipe for a new one, two files:
//   1. oc_core/volume/made_NAME.cpp: a function that returns its BuiltinVolumeKind, declared in
//      oc_core/volume/builtin_volume_list.h;
//   2. oc_core/volume/builtin_volumes.cpp: add it to the list.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oc_core/scene/builtin_parameters.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct BuiltinVolume {
  ScalarVolume volume;
  VolumeAppearance appearance;  ///< unless the user says another
};

struct BuiltinVolumeKind {
  std::string name;
  std::string summary;  ///< one line
  std::vector<BuiltinParameter> parameters;
  std::function<BuiltinVolume(const BuiltinValues&)> make;
};

const std::vector<BuiltinVolumeKind>& listBuiltinVolumes();

bool isBuiltinVolume(const std::string& source);

/// Throws InputError that lists the valid names, keys or the range, for a name, a key or a value that is wrong. The
/// same source gives the same bytes.
BuiltinVolume makeBuiltinVolume(const std::string& source);

}  // namespace ocelli
