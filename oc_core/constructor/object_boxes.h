// The boxes of a scene's objects, and of JSON files.
#pragma once

#include <string>
#include <vector>

#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class JsonFields;

/// By identity; empty where no triangle has it.
std::vector<Box> objectBoxes(const GuidedScene& scene);

/// {"lower": [x, y, z], "upper": [x, y, z]} in the field. Throws InputError where it is missing or no box.
Box readBox(JsonFields& fields, const std::string& name);

}  // namespace ocelli
