// `builtin:statues`: four copies of an object that hide parts of each other, on a checker floor before a brick wall.
#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

struct Place {
  float x;  ///< of the centre, as a part of the room's half width
  float z;  ///< the same, of its half depth
  float turnDegrees;
  glm::vec3 (*color)();
};

// From left to right; near ones stand before the gaps between the far ones.
constexpr std::array<Place, 4> kPlaces{{{-0.64f, -0.42f, 20, palette::skyBlue},
                                        {-0.25f, 0.50f, -15, palette::yellow},
                                        {0.18f, -0.38f, 10, palette::green},
                                        {0.58f, 0.44f, -30, palette::purple}}};

Scene buildStatues(const BuiltinValues& values) {
  Mesh room = makeRoom();
  Scene scene;
  Mesh statue = readObject(values, scene.warnings);
  const size_t wanted = std::max<size_t>(values.count("triangles"), room.triangles.size()) - room.triangles.size();
  densify(statue, wanted / kPlaces.size());

  const glm::vec3 size = boundsOf(statue).size();
  const float scale =
      std::min({0.95f * kRoomHalf.x / size.x, 0.90f * kRoomHalf.y * 2 / size.y, 0.95f * kRoomHalf.z / size.z});
  const bool plain = statue.colors.empty();
  scene.add(std::move(room));
  scene.meshes.push_back(std::move(statue));
  for (const Place& place : kPlaces) {
    glm::mat4 worldFromMesh =
        glm::translate(glm::mat4(1), {place.x * kRoomHalf.x, -kRoomHalf.y, place.z * kRoomHalf.z});
    worldFromMesh =
        glm::rotate(worldFromMesh, static_cast<float>(radiansFromDegrees(place.turnDegrees)), glm::vec3(0, 1, 0));
    worldFromMesh = glm::scale(worldFromMesh, glm::vec3(scale));
    scene.instances.push_back({1, worldFromMesh, plain ? place.color() : glm::vec3(1)});
  }
  tiltRoom(scene);
  return scene;
}

}  // namespace

BuiltinScene statuesScene() {
  return {"statues",
          "four copies of an object that hide parts of each other, on a floor before a wall",
          {meshParameter(), turnParameter(), trianglesParameter()},
          buildStatues};
}

}  // namespace ocelli
