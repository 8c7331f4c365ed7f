// `builtin:house`: a furnished house of one or two storeys, from a seed.
#include <algorithm>
#include <utility>

#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/dense_scene.h"
#include "oc_core/worlds/house_furniture.h"
#include "oc_core/worlds/house_mesh.h"
#include "oc_core/worlds/house_plan.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

constexpr float kShellCell = 0.4f;  // metres

/// What to keep in sight: of the piece in the middle of the list of furniture.
void aimAt(Scene& scene, uint32_t object) {
  const auto found = std::find_if(scene.instances.begin(), scene.instances.end(),
                                  [&](const Instance& instance) { return instance.object == object; });
  Box box;
  for (const glm::vec3& position : scene.meshes[found->mesh].positions) {
    box.add(glm::vec3(found->worldFromMesh * glm::vec4(position, 1)));
  }
  scene.guides.target = {object, box};
}

Scene buildHouse(const BuiltinValues& values) {
  const HousePlan plan = planHouse({values.count("seed"), static_cast<int>(values.count("storeys"))});
  Scene scene;
  scene.add(makeHouseShell(plan, kShellCell));
  uint32_t object = 0;
  for (const HouseDoor& door : plan.doors) {
    if (door.hasLeaf) {
      scene.add(makeDoorLeaf(door, palette::fromSrgbBytes(196, 146, 100)));
      scene.instances.back().object = ++object;
    }
  }
  const auto firstPiece = object + 1;
  for (const HouseFurniture& piece : plan.furniture) {
    scene.add(makeFurniture(piece.kind, piece.color), placedAt(piece.position, piece.turnDegrees));
    scene.instances.back().object = ++object;
  }
  aimAt(scene, firstPiece + static_cast<uint32_t>(plan.furniture.size() / 2));
  densifyScene(scene, values.count("triangles"));
  scene.guides.portals = housePortals(plan);
  scene.guides.path = housePath(plan);
  return scene;
}

}  // namespace

BuiltinScene houseScene() {
  return {"house",
          "a furnished house of rooms, corridors and stairs, whose doors stand open; in metres",
          {{"seed", "of the random numbers", BuiltinParameter::Kind::kInteger, "1", 0, 4294967295.0},
           {"storeys", "1 or 2; 0: as the seed has it", BuiltinParameter::Kind::kInteger, "0", 0, 2},
           trianglesParameter()},
          buildHouse};
}

}  // namespace ocelli
