// `builtin:mirror`: a mirroring vase before copies of an object, some of which hide others from it.
// `builtin:lens`: a ball of glass before the same.
#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr float kFloor = -0.5f;
constexpr uint32_t kShownObject = 1;  ///< what mirrors or refracts
constexpr uint32_t kFirstCopy = 2;

struct Copy {
  float x, z;      ///< where it stands
  float pedestal;  ///< how high
  float turnDegrees;
  glm::vec3 (*color)();
};

// Seen from the mirror's middle two near ones hide parts of the far ones behind them, and the fifth stands in the gap.
constexpr std::array<Copy, 5> kBeforeMirror{{{-0.55f, 0.15f, 0.08f, 20, palette::skyBlue},
                                             {-0.02f, 0.75f, 0.08f, -35, palette::yellow},
                                             {-1.10f, 0.42f, 0.34f, 70, palette::vermilion},
                                             {-0.25f, 1.50f, 0.34f, 10, palette::purple},
                                             {-0.72f, 0.85f, 0.20f, 130, palette::green}}};
// The same behind the ball of glass, for a viewer at +z.
constexpr std::array<Copy, 5> kBehindLens{{{-0.24f, -0.10f, 0, 20, palette::skyBlue},
                                           {0.26f, -0.14f, 0, -35, palette::yellow},
                                           {-0.40f, -0.50f, 0, 70, palette::vermilion},
                                           {0.46f, -0.52f, 0, 10, palette::purple},
                                           {0.02f, -0.36f, 0, 130, palette::green}}};

void addPedestal(Mesh& room, const Copy& copy, float side) {
  Mesh box = makeBox({side / 2, copy.pedestal / 2, side / 2});
  paint(box, palette::slate());
  append(room, box, placedAt({copy.x, kFloor + copy.pedestal / 2, copy.z}, static_cast<double>(copy.turnDegrees)));
}

/// A floor and a wall, then `shown`, then the copies.
Scene sceneAround(const BuiltinValues& values, Mesh shown, const glm::mat4& worldFromShown,
                  const std::array<Copy, 5>& copies, float copySize) {
  Scene scene;
  Mesh room;
  addCheckerFloor(room, {-1.5f, -0.8f}, {1, 1.9f}, kFloor, 15, 16, palette::slate(), palette::ivory());
  addBrickWall(room, {-1.5f, kFloor}, {1, 0.45f}, -0.8f, 9, 10);
  for (const Copy& copy : copies) {
    if (copy.pedestal > 0) {
      addPedestal(room, copy, 0.5f * copySize);
    }
  }
  const size_t others = room.triangles.size() + shown.triangles.size();
  scene.add(std::move(room));
  scene.add(std::move(shown), worldFromShown);
  scene.instances.back().object = kShownObject;
  scene.instances.back().tint = palette::ivory();

  Mesh object = readObject(values, scene.warnings);
  densify(object, (std::max(values.count("triangles"), others) - others) / copies.size());
  const glm::vec3 size = boundsOf(object).size();
  const float scale = copySize / std::max({size.x, size.y, size.z});
  const bool plain = object.colors.empty();
  scene.meshes.push_back(std::move(object));
  for (size_t i = 0; i < copies.size(); ++i) {
    const Copy& copy = copies[i];
    const glm::mat4 worldFromMesh = glm::scale(
        placedAt({copy.x, kFloor + copy.pedestal, copy.z}, static_cast<double>(copy.turnDegrees)), glm::vec3(scale));
    scene.instances.push_back({scene.meshes.size() - 1, worldFromMesh, plain ? copy.color() : glm::vec3(1),
                               kFirstCopy + static_cast<uint32_t>(i)});
  }
  tiltRoom(scene);
  return scene;
}

/// Nearly upright, so that its sides mirror what stands around it, and not the sky.
Mesh makeVase() {
  constexpr int kRings = 96;
  constexpr float kHeight = 0.85f;
  std::vector<glm::vec2> profile{{0, 0}};
  for (int i = 0; i <= kRings; ++i) {
    const float x = 2 * static_cast<float>(i) / kRings - 1;
    profile.emplace_back(0.37f - 0.05f * x * x, kHeight * (x + 1) / 2);
  }
  profile.emplace_back(0, kHeight);
  return makeTurned(profile, 192);
}

Scene buildMirror(const BuiltinValues& values) {
  return sceneAround(values, makeVase(), placedAt({0.3f, kFloor, -0.2f}), kBeforeMirror, 0.62f);
}

Scene buildLens(const BuiltinValues& values) {
  const glm::mat4 standing = glm::scale(glm::translate(glm::mat4(1), {0, kFloor + 0.36f, 0.42f}), glm::vec3(0.36f));
  return sceneAround(values, makeSphere(192), standing, kBehindLens, 0.42f);
}

std::vector<RoledObject> rolesOf(uint32_t shownRole) {
  std::vector<RoledObject> roles{{.object = 0, .roles = kIsBillboard | kReceives},
                                 {.object = kShownObject, .roles = shownRole}};
  for (uint32_t i = 0; i < kBeforeMirror.size(); ++i) {
    roles.push_back({.object = kFirstCopy + i, .roles = kCasts | kReceives});
  }
  return roles;
}

}  // namespace

BuiltinScene mirrorScene() {
  return {.name = "mirror",
          .summary = "a mirroring vase before five copies of an object (ocelli shade)",
          .parameters = {meshParameter(), turnParameter(), trianglesParameter()},
          .build = buildMirror,
          .roles = rolesOf(kMirrors)};
}

BuiltinScene lensScene() {
  return {.name = "lens",
          .summary = "a ball of glass before five copies of an object (ocelli shade)",
          .parameters = {meshParameter(), turnParameter(), trianglesParameter()},
          .build = buildLens,
          .roles = rolesOf(kRefracts)};
}

}  // namespace ocelli
