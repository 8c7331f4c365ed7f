// The made volumes, each defined in its own file. For builtin_volumes.cpp alone.
#pragma once

#include "oc_core/volume/builtin_volumes.h"

namespace ocelli {

BuiltinVolumeKind engineVolume();
BuiltinVolumeKind marschnerLobbVolume();
BuiltinVolumeKind noiseVolume();
BuiltinVolumeKind phantomVolume();
BuiltinVolumeKind rampVolume();
BuiltinVolumeKind skullVolume();
BuiltinVolumeKind slabVolume();
BuiltinVolumeKind sphereVolume();

}  // namespace ocelli
