// Files of where one can walk: JSON, described by walk_map.schema.json and docs/walkable.md. Maps that were found can
// be corrected by hand, and given back.
//
// Lengths and positions are in the units of the scene as its file has it, before it is fitted.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/scene/walk_map.h"

namespace ocelli {

class JsonFields;

/// Its parts are numbered anew, as its portals connect its cells. Throws InputError that says the file and the field.
WalkMap readWalkMap(const std::filesystem::path& path);
WalkMap walkMapFromJsonText(const std::string& text, const std::string& where);
/// From an object within another file; rejects unknown fields.
WalkMap readWalkMap(JsonFields& fields);

/// Reading it gives the same map again, but for the last digits of normals.
std::string jsonText(const WalkMap& map);

}  // namespace ocelli
