// What the scenes that show an object (`mesh=`, `triangles=`) have in common: the object, and the room that it stands
// in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {

/// The parameter `mesh`: a file, or the teapot.
BuiltinParameter meshParameter();
/// The parameter `turn`: degrees about the vertical, counter-clockwise seen from above.
BuiltinParameter turnParameter();
/// The parameter `triangles`: of the whole scene; 0 leaves the object as it is.
BuiltinParameter trianglesParameter();

/// The file that the user gave, as it is or below $OCELLI_DATA_DIR; `what` it is stands in the InputError that names
/// both places.
std::filesystem::path findFile(const std::string& given, const std::string& what);

/// The object of `mesh=`, turned by `turn=` and moved so that it stands on y = 0 with the centre of its box over the
/// origin. What the user should know of the file is added to `warnings`. Throws InputError that names both places where
/// the file was looked for.
Mesh readObject(const BuiltinValues& values, std::vector<std::string>& warnings);

/// A room without side walls: a brick wall at z = -kRoomHalf.z and a checker floor at y = -kRoomHalf.y. Both end at the
/// box of half sizes kRoomHalf, which just fits the unit sphere.
inline constexpr glm::vec3 kRoomHalf{0.70f, 0.55f, 0.45f};
Mesh makeRoom();

/// Tilts everything towards the viewer, about the x axis: the default view is level, and would see a level floor
/// edge-on.
void tiltRoom(Scene& scene);

}  // namespace ocelli
