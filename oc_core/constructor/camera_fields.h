// Fields that several files of cameras have: planes, points, the view.
// Include it in .cpp files only, as json_fields.h.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/base/json_fields.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/plane.h"

namespace ocelli {

/// A point or a direction, three numbers of at most 1e6.
glm::dvec3 readVector(JsonFields& fields, const std::string& name);
/// {"point": [x, y, z], "normal": [x, y, z]}.
Plane readPlane(const nlohmann::json& json, const std::string& where);
/// The field "size", {"width": 1280, "height": 720}; nothing where it is missing.
std::optional<glm::ivec2> readSize(JsonFields& fields);
/// The camera of the view in the field "view", of the size of `reference`; `reference` where there is no such field.
/// Throws InputError where the field "size" has another shape than `reference`: rays would run elsewhere.
PinholeCamera readRoot(JsonFields& fields, const PinholeCamera& reference);

nlohmann::ordered_json jsonOf(const glm::dvec3& vector);
nlohmann::ordered_json jsonOf(const Plane& plane);
/// The fields "view" and "size".
void writeRoot(nlohmann::ordered_json& json, const PinholeCamera& root);

}  // namespace ocelli
