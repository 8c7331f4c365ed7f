#include "oc_core/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/worlds/solids.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

Mesh oneTriangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(Scene, FlattenMovesAndTintsEachCopy) {
  Scene scene;
  Mesh colored = oneTriangle();
  paint(colored, {0.5f, 0.5f, 1.0f});
  scene.add(colored);
  scene.instances.push_back({0, glm::translate(glm::mat4(1), {5, 0, 0}), {1.0f, 0.5f, 0.25f}});
  const Mesh flat = flatten(scene);
  ASSERT_EQ(flat.positions.size(), 6u);
  EXPECT_EQ(triangleCount(scene), 2u);
  EXPECT_EQ(flat.positions[4], glm::vec3(6, 0, 0));
  EXPECT_EQ(flat.triangles[1], glm::uvec3(3, 4, 5));
  EXPECT_EQ(flat.colors[0], glm::vec3(0.5f, 0.5f, 1.0f));
  EXPECT_EQ(flat.colors[3], glm::vec3(0.5f, 0.25f, 0.25f));
}

TEST(Scene, FlattenLeavesColorsOutWhereAllIsWhite) {
  Scene scene;
  scene.add(oneTriangle());
  scene.add(oneTriangle());
  EXPECT_TRUE(flatten(scene).colors.empty());
  scene.meshes[1].colors.assign(3, glm::vec3(0.5f));
  const Mesh flat = flatten(scene);
  ASSERT_EQ(flat.colors.size(), 6u);
  EXPECT_EQ(flat.colors[0], glm::vec3(1));
  EXPECT_EQ(flat.colors[5], glm::vec3(0.5f));
}

TEST(Scene, MirroredCopyKeepsItsOutsideOutside) {
  Scene scene;
  scene.add(makeBox(glm::vec3(1)), glm::scale(glm::mat4(1), {-1, 1, 1}));
  const Mesh flat = flatten(scene);
  EXPECT_TRUE(isClosed(flat));
  EXPECT_DOUBLE_EQ(signedVolume(flat), 8.0);
}

TEST(Scene, KnowsTheObjectOfEachTriangle) {
  Scene scene;
  scene.add(makeBox(glm::vec3(1)));
  scene.instances.push_back({0, glm::mat4(1), glm::vec3(1), 7});
  scene.add(makeSphere(3));
  scene.instances.back().object = 2;
  std::vector<uint32_t> expected(12, 0);
  expected.insert(expected.end(), 12, 7);
  expected.insert(expected.end(), scene.meshes[1].triangles.size(), 2);
  EXPECT_EQ(objectOfTriangles(scene), expected);
  EXPECT_EQ(flatten(scene).triangles.size(), expected.size());
  EXPECT_TRUE(objectOfTriangles(Scene()).empty());
}

TEST(UnitFromWorld, PutsTheBoundingSphereOntoTheUnitSphere) {
  Mesh mesh = makeBox({1, 2, 3});
  transform(mesh, glm::translate(glm::mat4(1), {10, -20, 30}));
  transform(mesh, unitFromWorld(mesh, "test"));
  for (const glm::vec3& position : mesh.positions) {
    EXPECT_NEAR(glm::length(position), 1.0f, 1e-5f);  // float rounding at coordinates of 30: 30 * 2^-24 / radius 3.7
  }
}

TEST(UnitFromWorld, RejectsAMeshWithoutExtent) {
  Mesh point = oneTriangle();
  point.positions.assign(3, glm::vec3(7));
  EXPECT_THROW(unitFromWorld(point, "test"), InputError);
}

TEST(UnitFromWorld, TakesExtremeSizes) {
  for (const float size : {1e-15f, 1e15f}) {
    Mesh mesh = makeBox(glm::vec3(size));
    transform(mesh, unitFromWorld(mesh, "test"));
    EXPECT_NEAR(glm::length(mesh.positions[0]), 1.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace ocelli
