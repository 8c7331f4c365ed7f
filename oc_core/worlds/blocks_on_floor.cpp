#include "oc_core/worlds/blocks_on_floor.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr float kFloorHalf = 0.69f;  // its corners are on a circle of radius 0.98 then
constexpr float kFloorY = -0.15f;

/// One place for each block: cells of a square grid in random order, each left by its centre so far that blocks stay
/// apart.
std::vector<glm::vec2> placesOf(size_t count, float radius, float cell, size_t side, Random& random) {
  std::vector<size_t> order(side * side);
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  random.shuffle(order);
  std::vector<glm::vec2> places;
  const float play = cell / 2 - radius;
  for (size_t i = 0; i < count; ++i) {
    const size_t column = order[i] % side;
    const size_t row = order[i] / side;
    const float x = cell * (static_cast<float>(column) + 0.5f) + random.inRange(-play, play);
    const float z = cell * (static_cast<float>(row) + 0.5f) + random.inRange(-play, play);
    places.emplace_back(x - kFloorHalf, z - kFloorHalf);
  }
  return places;
}

}  // namespace

Scene makeBlocksOnFloor(size_t count, uint64_t seed) {
  OC_CHECK(count >= 1, "there is a target");
  const std::vector<glm::vec3> colors{palette::skyBlue(), palette::green(),  palette::yellow(),
                                      palette::blue(),    palette::purple(), palette::ivory()};
  Random random(seed);
  // A quarter of the places stays free.
  const auto side = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(count) / 0.75)));
  const float cell = 2 * kFloorHalf / static_cast<float>(side);
  const float radius = 0.46f * cell;
  const std::vector<glm::vec2> places = placesOf(count, radius, cell, side, random);
  const auto target = static_cast<size_t>(
      std::min_element(places.begin(), places.end(),
                       [](const glm::vec2& a, const glm::vec2& b) { return glm::dot(a, a) < glm::dot(b, b); }) -
      places.begin());

  Scene scene;
  Mesh floor;
  addCheckerFloor(floor, glm::vec2(-kFloorHalf), glm::vec2(kFloorHalf), kFloorY, 24, 24, palette::slate(),
                  palette::fromSrgbBytes(150, 160, 172));
  scene.add(std::move(floor));
  scene.meshes.push_back(makeBox(glm::vec3(1)));
  const float tallest = std::min(2.2f * cell, 0.5f);
  for (size_t i = 0; i < count; ++i) {
    glm::vec3 half;
    half.x = random.inRange(0.42f, 0.7f) * radius;
    half.z = random.inRange(0.35f, 0.7f) * radius;  // 0.7 sqrt(2) < 1: within the radius however it turns
    half.y = (i == target ? 0.28f : random.inRange(0.1f, 0.5f)) * tallest;
    const float angle = random.inRange(0, static_cast<float>(kPi));
    glm::vec3 color = colors[random.below(colors.size())];
    if (i == target) {
      color = palette::fromSrgbBytes(225, 30, 35);
    }
    const glm::vec3 center(places[i].x, kFloorY + half.y, places[i].y);
    const glm::mat4 standing = glm::rotate(glm::translate(glm::mat4(1), center), angle, glm::vec3(0, 1, 0));
    scene.instances.push_back({1, glm::scale(standing, half), color, static_cast<uint32_t>(i + 1)});
    if (i == target) {
      Mesh box;
      append(box, scene.meshes[1], scene.instances.back().worldFromMesh);
      scene.guides.target = {static_cast<uint32_t>(i + 1), boundsOf(box)};
    }
  }
  return scene;
}

}  // namespace ocelli
