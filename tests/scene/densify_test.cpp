#include "oc_core/scene/densify.h"

#include <gtest/gtest.h>

#include "oc_core/scene/edge_split.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/teapot.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

TEST(FindEdges, CountsTheEdgesOfABox) {
  const EdgeList list = findEdges(makeBox(glm::vec3(1)));
  EXPECT_EQ(list.edges.size(), 18u);  // Euler: 8 + 12 - 2
  for (const Edge& edge : list.edges) {
    EXPECT_EQ(edge.triangles, 2u);
    EXPECT_LT(edge.low, edge.high);
  }
}

class Densify : public testing::TestWithParam<size_t> {};

TEST_P(Densify, ReachesTheCountWithoutACrackOnTheSameSurface) {
  Mesh box = makeBox({1, 2, 3});
  densify(box, GetParam());
  EXPECT_GE(box.triangles.size(), GetParam());
  EXPECT_LE(box.triangles.size(), GetParam() + 1);
  EXPECT_TRUE(isClosed(box));
  EXPECT_NEAR(areaOf(box), 88.0, 1e-9);        // midpoints of these coordinates are exact
  EXPECT_NEAR(signedVolume(box), 48.0, 1e-9);  // orientation kept
}

INSTANTIATE_TEST_SUITE_P(Counts, Densify, testing::Values(12, 13, 14, 47, 48, 49, 1000, 12345));

TEST(DensifyMesh, LeavesAMeshThatIsDenseEnough) {
  Mesh teapot = makeTeapot(4);
  const Mesh before = teapot;
  densify(teapot, before.triangles.size());
  EXPECT_EQ(teapot.triangles, before.triangles);
  EXPECT_EQ(teapot.positions, before.positions);
}

TEST(DensifyMesh, SplitsTheLongestEdgesFirst) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 1, 0}, {0, 0, 5}, {0.1f, 0, 5}, {0, 0.1f, 5}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  densify(mesh, 3);
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.positions.back(), glm::vec3(5, 0.5f, 0));
}

TEST(DensifyMesh, InterpolatesColors) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.colors = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  densify(mesh, 4);
  ASSERT_EQ(mesh.triangles.size(), 4u);
  ASSERT_EQ(mesh.colors.size(), 6u);
  EXPECT_EQ(mesh.colors[3], glm::vec3(0.5f, 0, 0.5f));
}

TEST(DensifyMesh, EndsOnDegenerateTriangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.triangles = {{0, 0, 0}};
  densify(mesh, 100);
  EXPECT_GE(mesh.triangles.size(), 100u);
}

}  // namespace
}  // namespace ocelli
