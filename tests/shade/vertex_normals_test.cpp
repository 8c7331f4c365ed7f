#include "oc_core/shade/vertex_normals.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/worlds/solids.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

TEST(VertexNormals, ofASphereLeadOutwards) {
  const Mesh sphere = makeSphere(64);
  const std::vector<glm::vec3> normals = vertexNormals(sphere);
  for (size_t i = 0; i < normals.size(); ++i) {
    // Faces of 5.6 degrees; means of four or more of them.
    EXPECT_GT(glm::dot(normals[i], glm::normalize(sphere.positions[i])), 0.999f);
  }
}

TEST(VertexNormals, joinVerticesAtOnePlaceButNotAcrossCreases) {
  // A roof of 10 degrees whose ridge has two vertices at each end, and an upright wall at one of them.
  Mesh mesh;
  const float slope = std::tan(0.0873f);
  test::addQuad(mesh, {-1, -slope, 0}, {0, 0, 0}, {0, 0, -1}, {-1, -slope, -1});
  test::addQuad(mesh, {0, 0, 0}, {1, -slope, 0}, {1, -slope, -1}, {0, 0, -1});
  test::addQuad(mesh, {0, 0, 0}, {0, 0, -1}, {0, 1, -1}, {0, 1, 0});
  const std::vector<glm::vec3> normals = vertexNormals(mesh);
  // Two triangles of one side and one of the other meet there: the mean leans by a third of the slope.
  EXPECT_LT(glm::distance(normals[1], glm::normalize(glm::vec3(slope / 3, 1, 0))), 1e-3f) << "the ridge";
  EXPECT_EQ(normals[4], normals[1]);
  EXPECT_NEAR(std::abs(normals[8].x), 1, 1e-5f) << "the wall keeps its own";
}

TEST(VertexNormals, faceWhereTheRayComesFrom) {
  const Mesh mesh = test::wall(0, 1);
  const std::vector<glm::vec3> normals = vertexNormals(mesh);
  const Fragment fragment{1, 0, 0.25f, 0.25f};
  EXPECT_EQ(normalAt(fragment, mesh, normals, {0, 0, -1}), glm::vec3(0, 0, 1));
  EXPECT_EQ(normalAt(fragment, mesh, normals, {0, 0, 1}), glm::vec3(0, 0, -1));
}

TEST(VertexNormals, existWithoutAFace) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(vertexNormals(mesh)[1], glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace ocelli
