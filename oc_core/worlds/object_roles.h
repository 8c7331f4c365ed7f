// What the objects of a scene are to light that a picture follows further than to the first surface: which of them
// mirror or refract, and what stands for the others where such rays go (`ocelli shade`).
//
// Built-in scenes have their own roles (builtin_scenes.h). For others a JSON file says them, object_roles.schema.json;
// it may add objects that the scene lacks.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/area_light.h"

namespace ocelli {

struct ObjectRole {
  const char* name;
  const char* meaning;
  uint32_t bit;
};

inline constexpr uint32_t kMirrors = 1;
inline constexpr uint32_t kRefracts = 2;
inline constexpr uint32_t kCasts = 4;
inline constexpr uint32_t kReceives = 8;
inline constexpr uint32_t kIsBillboard = 16;
inline constexpr uint32_t kIsRelief = 32;
inline constexpr uint32_t kShines = 64;

/// All there are, in the order of lists.
inline constexpr std::array<ObjectRole, 7> kObjectRoles{{
    {"mirror", "a perfect mirror: it shows what its reflected rays meet; if it is cast too, other rays go on from it",
     kMirrors},
    {"refract", "clear glass: it shows what its refracted rays meet", kRefracts},
    {"cast", "what depth images stand for, where rays meet it", kCasts},
    {"receive", "shadows and ambient light are measured on it", kReceives},
    {"billboard", "of few triangles: rays meet it exactly, beside every depth image", kIsBillboard},
    {"relief", "one image of it is made and drawn wherever it stands: relief tiles", kIsRelief},
    {"light", "a flat panel that is the light of soft shadows, or a light that comes to the scene", kShines},
}};

/// An object of a scene, or one that comes to it.
struct RoledObject {
  uint32_t object = 0;  ///< its identity in the scene; of no meaning for one that comes
  uint32_t roles = 0;   ///< bits
  double refractiveIndex = 1.5;
  /// A scene of its own, fitted to the sphere of that radius around that centre; empty for an object of the scene.
  std::string source = {};
  glm::vec3 center{0};
  double radius = 0.3;
  double turnDegrees = 0;  ///< about the vertical, counter-clockwise seen from above
  /// More copies of it, as centre and turn in degrees; then `center` and `turnDegrees` say nothing. Only of tiles.
  std::vector<glm::dvec4> places = {};
  /// A light that comes; nothing for objects, also for a panel of the scene that is the light.
  std::optional<AreaLight> light = {};

  bool has(uint32_t role) const { return (roles & role) != 0; }
};

/// Throws InputError that says the file and the field.
std::vector<RoledObject> readObjectRoles(const std::filesystem::path& path);
std::vector<RoledObject> objectRolesFromJsonText(const std::string& text, const std::string& where);

}  // namespace ocelli
