#include "oc_core/scene/winding_number.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

/// A square in the plane z = `z` that faces +z.
Mesh wall(float z, float half) {
  Mesh mesh;
  mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(WindingNumber, isOneInsideAndZeroOutside) {
  for (const Mesh& solid : {makeBox({0.5f, 0.7f, 0.9f}), makeSphere(32), makeTorus(0.3f, 40)}) {
    EXPECT_NEAR(windingNumber(solid, {2, 1, 0.5f}), 0, 1e-9);
  }
  EXPECT_NEAR(windingNumber(makeBox(glm::vec3(0.5f)), {0.4f, -0.4f, 0.1f}), 1, 1e-9);
  EXPECT_NEAR(windingNumber(makeTorus(0.3f, 40), {0.7f, 0, 0}), 1, 1e-9) << "in the tube";
  EXPECT_NEAR(windingNumber(makeTorus(0.3f, 40), {0, 0, 0}), 0, 1e-9) << "in the hole of the ring";
}

// From the middle of a cube each of its sides fills a sixth of all directions.
TEST(WindingNumber, ofAnOpenSurfaceIsItsShareOfTheDirections) {
  EXPECT_NEAR(windingNumber(wall(1, 1), {0, 0, 0}), 1 / 6.0, 1e-7) << "seen from behind";
  EXPECT_NEAR(windingNumber(wall(-1, 1), {0, 0, 0}), -1 / 6.0, 1e-7) << "seen from its front";
}

TEST(RequireOutside, refusesEyesInsideOfClosedObjects) {
  const Mesh box = makeBox(glm::vec3(0.5f));
  EXPECT_THROW(requireOutside(box, {0.1f, 0.2f, 0.3f}, "view"), InputError);
  EXPECT_NO_THROW(requireOutside(box, {0.1f, 0.2f, 0.6f}, "view"));
  Mesh inverted = box;
  for (glm::uvec3& t : inverted.triangles) {
    std::swap(t.x, t.y);
  }
  EXPECT_THROW(requireOutside(inverted, {0.1f, 0.2f, 0.3f}, "view"), InputError) << "whichever way it faces";
}

// The wall behind the box takes a third of the directions away from the sum over the scene.
TEST(RequireOutside, refusesEyesInsideOfOneObjectAmongOthers) {
  Mesh room = wall(-0.9f, 3);
  append(room, makeBox(glm::vec3(0.5f)));
  append(room, makeBox(glm::vec3(0.1f)), glm::translate(glm::mat4(1), glm::vec3(2, 0, 0)));
  ASSERT_LT(windingNumber(room, {0, 0, 0}), 0.8);
  EXPECT_THROW(requireOutside(room, {0, 0, 0}, "view"), InputError);
  EXPECT_THROW(requireOutside(room, {2.05f, 0, 0}, "view"), InputError);
  EXPECT_NO_THROW(requireOutside(room, {1, 0, 0}, "view")) << "between them";
  EXPECT_NO_THROW(requireOutside(room, {0, 0, -0.7f}, "view")) << "between box and wall";
}

TEST(RequireOutside, refusesEyesInsideOfUnjoinedTriangles) {
  const Mesh sphere = makeSphere(16);
  Mesh soup;
  for (const glm::uvec3& t : sphere.triangles) {
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (int i = 0; i < 3; ++i) {
      soup.positions.push_back(sphere.positions[t[i]]);
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_THROW(requireOutside(soup, {0.1f, 0.2f, 0.3f}, "view"), InputError);
}

TEST(RequireOutside, allowsOpenRooms) {
  Mesh room = wall(-1, 1);
  append(room, wall(-1, 1), glm::rotate(glm::mat4(1), 1.5707963f, glm::vec3(1, 0, 0)));
  append(room, wall(-1, 1), glm::rotate(glm::mat4(1), 1.5707963f, glm::vec3(0, 1, 0)));
  EXPECT_NO_THROW(requireOutside(room, {0, 0, 0}, "view"));
}

TEST(RequireOutside, refusesEyesInsideOfABlockOfTheBuiltinScene) {
  const Mesh boxes = loadScene("builtin:boxes,count=5");
  // The first block: eight vertices.
  glm::vec3 middle(0);
  for (size_t i = 0; i < 8; ++i) {
    middle += boxes.positions[i] / 8.0f;
  }
  EXPECT_THROW(requireOutside(boxes, middle, "view"), InputError);
  EXPECT_NO_THROW(requireOutside(boxes, {0, 0, 10}, "view"));
}

}  // namespace
}  // namespace ocelli
