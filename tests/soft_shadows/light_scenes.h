// A light over some occluders, whose shadows are known.
#pragma once

#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "oc_core/base/random.h"
#include "oc_core/soft_shadows/area_visibility.h"
#include "oc_core/worlds/solids.h"

namespace ocelli::test {

/// A light of 2 x 1 at height 4 over the origin that shines down, with x as its width. In its frame a point (x, y, z)
/// is at (x, z, 4 - y), up to the sign of the second.
inline AreaLight lightAbove(bool isDisc = false, float width = 2, float height = 1) {
  return areaLightTowards({0, 4, 0}, {0, 0, 0}, width, height, isDisc, 0, "test");
}

/// A point of the floor y = 0.
inline ShadowReceiver onFloor(float x, float z) {
  return {{x, 0, z}, {0, 1, 0}};
}

/// A rectangle at height y.
inline Mesh plate(float x0, float x1, float z0, float z1, float y) {
  Mesh mesh;
  mesh.positions = {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Boxes at random places between the floor and the light, some of which meet each other.
inline Mesh randomBoxes(int count, uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float x = random.inRange(-1.5f, 1.5f);
    const float y = random.inRange(0.6f, 3.2f);
    const float z = random.inRange(-1.5f, 1.5f);
    const float side = random.inRange(0.05f, 0.4f);
    const float angle = random.inRange(0, 6);
    const glm::vec3 axis(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(0.1f, 1));
    append(mesh, makeBox({side, side * 0.6f, side * 0.3f}),
           glm::rotate(glm::translate(glm::mat4(1), {x, y, z}), angle, glm::normalize(axis)));
  }
  return mesh;
}

/// Triangles that share nothing and are turned either way.
inline Mesh randomTriangles(int count, uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float cx = random.inRange(-1.5f, 1.5f);
    const float cy = random.inRange(0.5f, 3.3f);
    const float cz = random.inRange(-1.5f, 1.5f);
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 3; ++corner) {
      const float x = random.inRange(-0.6f, 0.6f);
      const float y = random.inRange(-0.4f, 0.4f);
      const float z = random.inRange(-0.6f, 0.6f);
      mesh.positions.push_back({cx + x, cy + y, cz + z});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

inline std::vector<ShadowReceiver> floorGrid(int side, float half) {
  std::vector<ShadowReceiver> receivers;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const auto at = [&](int k) {
        return (static_cast<float>(k) + 0.5f) / static_cast<float>(side) * 2 * half - half;
      };
      receivers.push_back(onFloor(at(i), at(j)));
    }
  }
  return receivers;
}

}  // namespace ocelli::test
