// `builtin:room`: an object on a checker floor before a brick wall.
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

Scene buildRoom(const BuiltinValues& values) {
  Mesh room = makeRoom();
  Scene scene;
  Mesh object = readObject(values, scene.warnings);
  densify(object, std::max<size_t>(values.count("triangles"), room.triangles.size()) - room.triangles.size());

  const glm::vec3 size = boundsOf(object).size();
  const float scale =
      std::min({1.86f * kRoomHalf.x / size.x, 1.68f * kRoomHalf.y / size.y, 1.72f * kRoomHalf.z / size.z});
  const bool plain = object.colors.empty();
  scene.add(std::move(room));
  scene.add(std::move(object), glm::scale(glm::translate(glm::mat4(1), {0, -kRoomHalf.y, 0}), glm::vec3(scale)));
  scene.instances.back().tint = plain ? palette::yellow() : glm::vec3(1);
  tiltRoom(scene);
  return scene;
}

}  // namespace

BuiltinScene roomScene() {
  return {"room",
          "an object on a checker floor before a brick wall",
          {meshParameter(), turnParameter(), trianglesParameter()},
          buildRoom};
}

}  // namespace ocelli
