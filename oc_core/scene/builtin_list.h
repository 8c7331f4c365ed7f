// The built-in scenes, each defined in its own file. For builtin_scenes.cpp alone.
#pragma once

#include "oc_core/scene/builtin_scenes.h"

namespace ocelli {

BuiltinScene roomScene();
BuiltinScene statuesScene();

}  // namespace ocelli
