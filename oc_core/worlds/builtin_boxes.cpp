// `builtin:boxes`: seeded random blocks that float in the unit sphere, or stand on a floor, and hide parts of each
// other.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/blocks_on_floor.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

/// Throws darts into the unit sphere until `count` balls of the given radius stand in it and none meets another.
std::vector<glm::vec3> separateCenters(size_t count, float radius, Random& random) {
  const auto side = static_cast<size_t>(std::floor(1 / radius)) + 1;  // cells are at least a diameter wide
  std::vector<std::vector<glm::vec3>> cells(side * side * side);
  const auto cellOf = [&](float x) {
    return std::min(static_cast<size_t>((x + 1) * 0.5f * static_cast<float>(side - 1)), side - 1);
  };
  const auto isFree = [&](const glm::vec3& center) {
    const auto below = [](size_t i) { return i > 0 ? i - 1 : 0; };
    const auto above = [&](size_t i) { return std::min(i + 1, side - 1); };
    const size_t i = cellOf(center.x);
    const size_t j = cellOf(center.y);
    const size_t k = cellOf(center.z);
    for (size_t x = below(i); x <= above(i); ++x) {
      for (size_t y = below(j); y <= above(j); ++y) {
        for (size_t z = below(k); z <= above(k); ++z) {
          for (const glm::vec3& other : cells[(x * side + y) * side + z]) {
            if (glm::distance(center, other) < 2 * radius) {
              return false;
            }
          }
        }
      }
    }
    return true;
  };
  std::vector<glm::vec3> centers;
  while (centers.size() < count) {
    const float x = random.inRange(-1, 1);
    const float y = random.inRange(-1, 1);
    const glm::vec3 center(x, y, random.inRange(-1, 1));
    if (glm::length(center) + radius <= 1 && isFree(center)) {
      cells[(cellOf(center.x) * side + cellOf(center.y)) * side + cellOf(center.z)].push_back(center);
      centers.push_back(center);
    }
  }
  return centers;
}

Scene buildBoxes(const BuiltinValues& values) {
  if (values.count("floor") == 1) {
    return makeBlocksOnFloor(values.count("count"), values.count("seed"));
  }
  const std::vector<glm::vec3> colors{palette::orange(), palette::skyBlue(),   palette::green(), palette::yellow(),
                                      palette::blue(),   palette::vermilion(), palette::purple()};
  const size_t count = values.count("count");
  Random random(values.count("seed"));
  // Balls that fill a fifth of the sphere: darts still find a place soon (they would not above 0.38).
  const float radius = std::cbrt(0.2f / static_cast<float>(count));
  const std::vector<glm::vec3> centers = separateCenters(count, radius, random);
  Scene scene;
  scene.meshes.push_back(makeBox(glm::vec3(1)));
  for (const glm::vec3& center : centers) {
    // One draw a statement: the order in which arguments are evaluated is not fixed.
    glm::vec3 axis;
    glm::vec3 half;
    for (glm::length_t i = 0; i < 3; ++i) {
      axis[i] = random.inRange(-1, 1);
      half[i] = random.inRange(0.45f, 1.0f) * radius / std::sqrt(3.0f);
    }
    const float angle = random.inRange(0, static_cast<float>(2 * kPi));
    glm::mat4 worldFromMesh = glm::translate(glm::mat4(1), center);
    worldFromMesh = glm::rotate(worldFromMesh, angle, glm::normalize(axis + glm::vec3(0, 1e-3f, 0)));
    const glm::vec3 color = colors[random.next() % colors.size()];
    scene.instances.push_back(
        {0, glm::scale(worldFromMesh, half), color, static_cast<uint32_t>(scene.instances.size() + 1)});
  }
  return scene;
}

}  // namespace

BuiltinScene boxesScene() {
  return {"boxes",
          "seeded random blocks that float and hide parts of each other",
          {{"count", "how many", BuiltinParameter::Kind::kInteger, "120", 1, 1'000'000},
           {"seed", "of the random numbers", BuiltinParameter::Kind::kInteger, "1", 0, 4294967295.0},
           {"floor", "1: they stand on a floor, and one near the middle is red", BuiltinParameter::Kind::kInteger, "0",
            0, 1}},
          buildBoxes};
}

}  // namespace ocelli
