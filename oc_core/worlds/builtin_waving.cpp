// `builtin:waving`: a scene all of whose triangles move (waving_scene.h): an object, or the statues with their room.
#include <memory>

#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/waving_scene.h"

namespace ocelli {
namespace {

Scene buildWaving(const BuiltinValues& values) {
  if (values.number("room") != 0) {
    return statuesScene().build(values);
  }
  Scene scene;
  Mesh object = readObject(values, scene.warnings);
  densify(object, values.count("triangles"));
  const bool plain = object.colors.empty();
  scene.add(std::move(object));
  scene.instances.back().tint = plain ? palette::orange() : glm::vec3(1);
  return scene;
}

std::unique_ptr<MovingScene> moveWaving(const BuiltinValues& values) {
  Mesh mesh = flatten(buildWaving(values));
  const float sway = static_cast<float>(values.number("sway")) * boundsOf(mesh).size().y;
  return std::make_unique<WavingScene>(std::move(mesh), values.number("seconds"), sway);
}

}  // namespace

BuiltinScene wavingScene() {
  using Kind = BuiltinParameter::Kind;
  return {"waving",
          "an object that waves like a plant in a current: all of its triangles move (--time, or ocelli present)",
          {meshParameter(),
           turnParameter(),
           trianglesParameter(),
           {"room", "1: four copies of it in a room, as builtin:statues has them; all of that waves", Kind::kInteger,
            "0", 0, 1},
           {"seconds", "of one round of the motion, which repeats", Kind::kNumber, "4", 0.01, 3600},
           {"sway", "how far it moves to each side, in heights of the scene", Kind::kNumber, "0.08", 0, 10}},
          buildWaving,
          moveWaving};
}

}  // namespace ocelli
