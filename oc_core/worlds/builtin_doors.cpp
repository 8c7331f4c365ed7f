// `builtin:doors`: a double door, ajar, with an object in the room behind it: what the slit shows moves with the eye.
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr float kDoorHalfWidth = 0.40f;
constexpr float kDoorTop = 0.36f;
constexpr float kThickness = 0.03f;
constexpr float kWallZ = 0.08f;  // back of the front wall, and the hinges

float bottom() {
  return -kRoomHalf.y;
}

/// The wall around the opening, in cells that leave the opening out.
void addFrontWall(Scene& scene) {
  const auto addBlock = [&](const glm::vec2& lower, const glm::vec2& upper, size_t columns, size_t rows) {
    Mesh front;
    glm::mat4 worldFromPanel(1);
    worldFromPanel[3] = {0, 0, kWallZ + kThickness, 1};
    addPanel(front, evenLines(lower.x, upper.x, columns), evenLines(lower.y, upper.y, rows), worldFromPanel,
             [&](size_t i, size_t j) { return (i + j) % 2 == 0 ? palette::green() : palette::green() * 0.6f; });
    scene.add(std::move(front));
    // Its body, a little behind the pattern so that the two do not coincide.
    const glm::vec2 center = (lower + upper) * 0.5f;
    const glm::vec2 half = (upper - lower) * 0.5f;
    scene.add(makeBox({half, kThickness / 2 - 0.001f}),
              glm::translate(glm::mat4(1), {center, kWallZ + kThickness / 2 - 0.001f}));
    scene.instances.back().tint = palette::slate();
  };
  addBlock({-kRoomHalf.x, bottom()}, {-kDoorHalfWidth, kDoorTop}, 4, 12);
  addBlock({kDoorHalfWidth, bottom()}, {kRoomHalf.x, kDoorTop}, 4, 12);
  addBlock({-kRoomHalf.x, kDoorTop}, {kRoomHalf.x, kRoomHalf.y}, 19, 3);
}

/// One leaf in its own frame: hinge on the y axis at x = 0, the leaf towards +x, its front face on z = kThickness.
Mesh makeLeaf() {
  const float height = kDoorTop - bottom();
  Mesh leaf = makeBox({kDoorHalfWidth / 2, height / 2, kThickness / 2 - 0.001f});
  transform(leaf, glm::translate(glm::mat4(1), {kDoorHalfWidth / 2, height / 2, kThickness / 2 - 0.001f}));
  paint(leaf, palette::vermilion() * 0.8f);
  const std::vector<float> xs{0, 0.06f, kDoorHalfWidth - 0.06f, kDoorHalfWidth};
  const std::vector<float> ys{0, 0.07f, 0.40f, 0.47f, height - 0.07f, height};
  glm::mat4 worldFromPanel(1);
  worldFromPanel[3] = {0, 0, kThickness, 1};
  Mesh face;
  addPanel(face, xs, ys, worldFromPanel,
           [](size_t i, size_t j) { return i == 1 && j % 2 == 1 ? palette::orange() : palette::vermilion(); });
  append(leaf, face);
  Mesh knob = makeSphere(16);
  paint(knob, palette::yellow());
  append(leaf, knob,
         glm::scale(glm::translate(glm::mat4(1), {kDoorHalfWidth - 0.03f, 0.435f, kThickness + 0.012f}),
                    glm::vec3(0.018f)));
  return leaf;
}

Scene buildDoors(const BuiltinValues& values) {
  Scene scene;
  scene.add(makeRoom());
  addFrontWall(scene);
  const float angle = static_cast<float>(radiansFromDegrees(values.number("angle")));
  Mesh leaf = makeLeaf();
  scene.meshes.push_back(std::move(leaf));
  // The right leaf is the mirror image of the left one.
  for (const float side : {1.0f, -1.0f}) {
    glm::mat4 worldFromLeaf = glm::scale(glm::mat4(1), {side, 1, 1});
    worldFromLeaf = glm::translate(worldFromLeaf, {-kDoorHalfWidth, bottom(), kWallZ});
    worldFromLeaf = glm::rotate(worldFromLeaf, -angle, glm::vec3(0, 1, 0));
    scene.instances.push_back({scene.meshes.size() - 1, worldFromLeaf});
  }
  Mesh object = readObject(values, scene.warnings);
  const float depth = kRoomHalf.z + kWallZ;
  const glm::vec3 size = boundsOf(object).size();
  const float scale =
      std::min({1.9f * kDoorHalfWidth / size.x, 0.7f * (kDoorTop - bottom()) / size.y, 0.8f * depth / size.z});
  const bool plain = object.colors.empty();
  scene.add(std::move(object),
            glm::scale(glm::translate(glm::mat4(1), {0, bottom(), kWallZ - depth / 2}), glm::vec3(scale)));
  scene.instances.back().tint = plain ? palette::yellow() : glm::vec3(1);
  tiltRoom(scene);
  return scene;
}

}  // namespace

BuiltinScene doorsScene() {
  return {"doors",
          "a double door, ajar, with an object in the room behind it",
          {{"angle", "by which each leaf is open, in degrees", BuiltinParameter::Kind::kNumber, "38", 0, 110},
           meshParameter(),
           turnParameter()},
          buildDoors};
}

}  // namespace ocelli
