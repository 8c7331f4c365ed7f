// `builtin:lamp`: a lamp over copies of an object on a floor, whose penumbrae meet.
// `builtin:pergola`: a lamp over two layers of slats that cross, over a floor with one copy of the object.
#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <span>
#include <vector>

#include "oc_core/scene/area_light.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr float kGround = -0.5f;
constexpr uint32_t kLampObject = 1;
constexpr uint32_t kFirstUnderLamp = 2;

struct UnderLamp {
  float x, z;
  float scale;  ///< of the largest side
  float turnDegrees;
  glm::vec3 (*color)();
};

// The lamp hangs to the left and in front, so that shadows fall to the right and back, over each other and over what
// stands there.
constexpr std::array<UnderLamp, 5> kStatuesUnderLamp{{{-0.52f, 0.12f, 0.62f, 20, palette::skyBlue},
                                                      {0.06f, 0.40f, 0.50f, -35, palette::yellow},
                                                      {0.20f, -0.18f, 0.70f, 70, palette::vermilion},
                                                      {-0.40f, -0.42f, 0.55f, 10, palette::purple},
                                                      {0.72f, 0.18f, 0.50f, 130, palette::green}}};
constexpr std::array<UnderLamp, 1> kUnderPergola{{{0.1f, 0.1f, 0.6f, -20, palette::skyBlue}}};
constexpr glm::vec3 kLampPlace{-0.8f, 1.0f, 0.6f};
constexpr glm::vec3 kLampTarget{0.1f, kGround, 0};
constexpr uint32_t kSlatLayers = 2;

std::vector<BuiltinParameter> lampParameters() {
  return {meshParameter(),
          turnParameter(),
          trianglesParameter(),
          {"light", "side of the lamp, of about half the floor's width", BuiltinParameter::Kind::kNumber, "0.5", 0.01,
           1.5}};
}

void addFloorAndLamp(Scene& scene, const BuiltinValues& values) {
  Mesh floor;
  addCheckerFloor(floor, {-1, -0.8f}, {1.2f, 0.8f}, kGround, 11, 8, palette::slate(), palette::ivory());
  scene.add(std::move(floor));
  const auto side = static_cast<float>(values.number("light"));
  scene.add(panelOf(areaLightTowards(kLampPlace, kLampTarget, side, side, false, 0, "builtin:lamp")));
  scene.instances.back().object = kLampObject;
}

void addObjectsUnderLamp(Scene& scene, const BuiltinValues& values, std::span<const UnderLamp> copies,
                         uint32_t firstObject) {
  Mesh object = readObject(values, scene.warnings);
  const size_t others = triangleCount(scene);
  densify(object, (std::max(values.count("triangles"), others) - others) / copies.size());
  const glm::vec3 size = boundsOf(object).size();
  const bool plain = object.colors.empty();
  scene.meshes.push_back(std::move(object));
  for (size_t i = 0; i < copies.size(); ++i) {
    const UnderLamp& copy = copies[i];
    const float scale = copy.scale / std::max({size.x, size.y, size.z});
    scene.instances.push_back(
        {scene.meshes.size() - 1,
         glm::scale(placedAt({copy.x, kGround, copy.z}, static_cast<double>(copy.turnDegrees)), glm::vec3(scale)),
         plain ? copy.color() : glm::vec3(1), firstObject + static_cast<uint32_t>(i)});
  }
}

Scene buildLamp(const BuiltinValues& values) {
  Scene scene;
  addFloorAndLamp(scene, values);
  addObjectsUnderLamp(scene, values, kStatuesUnderLamp, kFirstUnderLamp);
  tiltRoom(scene);
  return scene;
}

/// Slats along x, and higher up along z: an object a layer.
Scene buildPergola(const BuiltinValues& values) {
  constexpr int kSlats = 9;
  constexpr float kPitch = 0.13f;
  Scene scene;
  addFloorAndLamp(scene, values);
  scene.meshes.push_back(makeBox({0.60f, 0.012f, 0.03f}));
  for (uint32_t layer = 0; layer < kSlatLayers; ++layer) {
    for (int i = 0; i < kSlats; ++i) {
      const float across = kPitch * static_cast<float>(i - kSlats / 2);
      const glm::vec3 place = layer == 0 ? glm::vec3(-0.1f, kGround + 0.75f, across + 0.1f)
                                         : glm::vec3(across - 0.1f, kGround + 0.95f, 0.1f);
      scene.instances.push_back({scene.meshes.size() - 1, placedAt(place, layer == 0 ? 0 : 90),
                                 layer == 0 ? palette::orange() : palette::yellow(), kFirstUnderLamp + layer});
    }
  }
  addObjectsUnderLamp(scene, values, kUnderPergola, kFirstUnderLamp + kSlatLayers);
  tiltRoom(scene);
  return scene;
}

std::vector<RoledObject> lampRoles(size_t objects) {
  std::vector<RoledObject> roles{{.object = 0, .roles = kIsBillboard | kReceives},
                                 {.object = kLampObject, .roles = kShines}};
  for (uint32_t i = 0; i < objects; ++i) {
    roles.push_back({.object = kFirstUnderLamp + i, .roles = kCasts | kReceives});
  }
  return roles;
}

}  // namespace

BuiltinScene lampScene() {
  return {.name = "lamp",
          .summary = "a lamp over five copies of an object on a floor (ocelli shade)",
          .parameters = lampParameters(),
          .build = buildLamp,
          .roles = lampRoles(kStatuesUnderLamp.size())};
}

BuiltinScene pergolaScene() {
  return {.name = "pergola",
          .summary = "a lamp over two layers of slats that cross, and an object below (ocelli shade)",
          .parameters = lampParameters(),
          .build = buildPergola,
          .roles = lampRoles(kSlatLayers + kUnderPergola.size())};
}

}  // namespace ocelli
