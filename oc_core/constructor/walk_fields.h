// What the constructors of cameras of walk maps read from JSON, and where they find the map.
#pragma once

#include <optional>
#include <string>

#include "oc_core/constructor/walk_camera.h"
#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

class JsonFields;

/// The map of a file, in the world of the scene; nothing where the field "ways" is missing.
std::optional<WalkMap> readWays(JsonFields& fields, const GuidedScene& scene);

/// That of `given`, else that of the scene's maze or of its guides, else the one that its geometry has
/// (oc_core/walkable). Throws InputError where there is no floor to walk on.
WalkMap walkMapFor(const GuidedScene& scene, std::optional<WalkMap> given);

/// What files say of a comprehensive camera of a walk map. The start can be a cell, or a point that a cell holds.
struct WalkStartFields {
  std::optional<uint32_t> cell{};
  std::optional<glm::dvec3> point{};
  std::optional<glm::dvec3> heading{};
};
/// The fields "start_cell", "start_point" and "heading_degrees".
WalkStartFields readWalkStart(JsonFields& fields);
/// Throws InputError where no cell holds the point.
std::optional<WalkStart> walkStartOf(const WalkMap& map, const WalkStartFields& fields);

/// The field "heading_degrees", clockwise from the north (-z), as a level unit vector; nothing where it is missing.
std::optional<glm::dvec3> readHeadingDegrees(JsonFields& fields);

}  // namespace ocelli
