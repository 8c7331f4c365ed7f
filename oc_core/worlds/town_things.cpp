#include "oc_core/worlds/town_things.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

void add(Mesh& mesh, Mesh part, const glm::mat4& worldFromPart, const glm::vec3& color) {
  paint(part, color);
  append(mesh, part, worldFromPart);
}

Mesh makeTrunk(float height) {
  Mesh tree;
  add(tree, makeTurned({{0, 0}, {0.34f, 0}, {0.2f, 0.5f}, {0.16f, height}, {0, height}}, 12), glm::mat4(1),
      palette::fromSrgbBytes(124, 86, 58));
  return tree;
}

}  // namespace

Mesh makeRoundTree(const glm::vec3& color) {
  Mesh tree = makeTrunk(2.6f);
  const auto addCrown = [&](const glm::vec3& center, float radius, float shade) {
    add(tree, makeSphere(16), glm::scale(placedAt(center), glm::vec3(radius)), color * shade);
  };
  addCrown({0, 3.7f, 0}, 1.45f, 1.0f);
  addCrown({0.9f, 3.0f, 0.3f}, 0.95f, 0.88f);
  addCrown({-0.8f, 3.1f, 0.5f}, 0.9f, 0.94f);
  addCrown({-0.1f, 3.0f, -0.9f}, 0.95f, 0.82f);
  return tree;
}

Mesh makePointedTree(const glm::vec3& color) {
  Mesh tree = makeTrunk(1.6f);
  for (int i = 0; i < 3; ++i) {
    const auto step = static_cast<float>(i);
    const float radius = 1.6f - 0.4f * step;
    add(tree, makeTurned({{0, 0}, {radius, -0.25f}, {0.5f * radius, 0.8f}, {0, 2.0f}}, 24),
        placedAt({0, 1.3f + 1.15f * step, 0}), color * (0.6f + 0.15f * step));
  }
  return tree;
}

Mesh makeCar(const glm::vec3& color) {
  Mesh car;
  add(car, makePrism({{-2, 0.35f}, {2, 0.35f}, {2, 0.72f}, {1.85f, 0.86f}, {-1.9f, 0.92f}, {-2, 0.8f}}, 0.85f),
      glm::mat4(1), color);
  add(car, makePrism({{-1.5f, 0.86f}, {0.95f, 0.82f}, {0.35f, 1.36f}, {-1.15f, 1.38f}}, 0.7f), glm::mat4(1),
      palette::fromSrgbBytes(70, 96, 120));
  add(car, makePrism({{-1.2f, 1.36f}, {0.4f, 1.34f}, {0.3f, 1.44f}, {-1.1f, 1.46f}}, 0.74f), glm::mat4(1), color);
  for (const float x : {-1.25f, 1.25f}) {
    for (const float side : {-90.0f, 90.0f}) {
      const glm::mat4 carFromWheel = placedAt({x, 0.36f, side > 0 ? 0.68f : -0.68f}, side, {1, 0, 0});
      add(car, makeTurned({{0, 0}, {0.36f, 0}, {0.36f, 0.2f}, {0.28f, 0.24f}, {0, 0.24f}}, 16), carFromWheel,
          palette::fromSrgbBytes(96, 96, 104));
      add(car, makeTurned({{0, 0.22f}, {0.19f, 0.22f}, {0.17f, 0.27f}, {0, 0.27f}}, 16), carFromWheel,
          palette::ivory() * 0.8f);
    }
  }
  for (const float z : {-0.58f, 0.58f}) {
    add(car, makeBox({0.05f, 0.09f, 0.16f}), placedAt({2.0f, 0.62f, z}), palette::yellow());
    add(car, makeBox({0.05f, 0.08f, 0.16f}), placedAt({-2.0f, 0.66f, z}), palette::vermilion());
  }
  return car;
}

Mesh makeLamp() {
  Mesh lamp;
  add(lamp, makeTurned({{0, 0}, {0.16f, 0}, {0.14f, 0.3f}, {0.06f, 0.5f}, {0.05f, 3.6f}, {0, 3.6f}}, 12), glm::mat4(1),
      palette::slate());
  add(lamp, makeBox({0.04f, 0.04f, 0.5f}), placedAt({0, 3.5f, 0.45f}), palette::slate());
  add(lamp, makeSphere(16), glm::scale(placedAt({0, 3.32f, 0.9f}), glm::vec3(0.2f)), palette::yellow());
  return lamp;
}

Mesh makeClockTower() {
  constexpr float kHalf = 2.6f;
  constexpr float kShaft = 15;
  const glm::vec3 stone = palette::fromSrgbBytes(236, 208, 168);
  Mesh tower;
  add(tower, makeBox({4, 0.4f, 4}), placedAt({0, 0.4f, 0}), palette::mortar());
  add(tower, makeBox({3.2f, 0.3f, 3.2f}), placedAt({0, 1.1f, 0}), palette::mortar() * 0.9f);
  add(tower, makeBox({kHalf - 0.3f, kShaft / 2, kHalf - 0.3f}), placedAt({0, 1 + kShaft / 2, 0}), stone * 0.5f);
  for (int side = 0; side < 4; ++side) {
    const glm::mat4 towerFromSide = placedAt({0, 0, 0}, 90 * side);
    // A face of the shaft with a row of narrow windows.
    WallSlab face;
    face.xs = evenLines(-kHalf, kHalf, 13);
    face.ys = evenLines(1.4f, 1 + kShaft, 34);
    face.thickness = 0.3f;
    face.back = stone;
    face.color = [&](size_t i, size_t j) {
      const bool corner = i < 2 || i > 10;
      return corner ? (j % 4 < 2 ? palette::brick() : palette::mortar()) : stone * (j % 2 == 0 ? 1.0f : 0.92f);
    };
    face.isOpen = [](size_t i, size_t j) { return i == 6 && j % 6 >= 2 && j % 6 < 5 && j < 24; };
    addSlab(tower, face, towerFromSide * placedAt({0, 0, kHalf}));
    // The clock.
    const glm::mat4 towerFromClock = towerFromSide * placedAt({0, 1 + kShaft - 2.4f, kHalf}, 90, {1, 0, 0});
    add(tower, makeTurned({{0, -0.1f}, {2.1f, -0.1f}, {2.1f, 0.18f}, {0, 0.18f}}, 48), towerFromClock,
        palette::slate());
    add(tower, makeTurned({{0, 0}, {1.85f, 0}, {1.85f, 0.22f}, {0, 0.22f}}, 48), towerFromClock, palette::ivory());
    const auto addHand = [&](double degrees, float from, float to, float halfWidth, const glm::vec3& color) {
      add(tower, makeBox({halfWidth, 0.04f, (to - from) / 2}),
          towerFromClock * placedAt({0, 0.26f, 0}, -degrees) * placedAt({0, 0, -(from + to) / 2}), color);
    };
    for (int hour = 0; hour < 12; ++hour) {
      addHand(30 * hour, hour % 3 == 0 ? 1.35f : 1.5f, 1.75f, hour % 3 == 0 ? 0.1f : 0.06f, palette::slate());
    }
    addHand(305, -0.25f, 1.0f, 0.11f, palette::slate());
    addHand(60, -0.3f, 1.5f, 0.07f, palette::vermilion());
  }
  // Cornice, belfry, roof.
  const float top = 1 + kShaft;
  add(tower, makeBox({3.1f, 0.35f, 3.1f}), placedAt({0, top + 0.35f, 0}), palette::mortar());
  for (const float x : {-2.2f, 2.2f}) {
    for (const float z : {-2.2f, 2.2f}) {
      add(tower, makeBox({0.4f, 1.6f, 0.4f}), placedAt({x, top + 2.3f, z}), stone);
    }
  }
  add(tower, makeTurned({{0, 0}, {0.9f, 0}, {0.75f, 0.3f}, {0.6f, 1.1f}, {0.3f, 1.4f}, {0, 1.45f}}, 32),
      placedAt({0, top + 1.3f, 0}), palette::yellow() * 0.8f);
  add(tower, makeBox({3.0f, 0.3f, 3.0f}), placedAt({0, top + 4.2f, 0}), palette::mortar());
  add(tower, makeTurned({{0, 0}, {4.1f, 0}, {0.6f, 4.2f}, {0, 6.5f}}, 4), placedAt({0, top + 4.5f, 0}, 45),
      palette::fromSrgbBytes(64, 128, 122));
  add(tower, makeSphere(16), glm::scale(placedAt({0, top + 11.1f, 0}), glm::vec3(0.35f)), palette::yellow());
  return tower;
}

}  // namespace ocelli
