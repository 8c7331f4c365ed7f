#include "oc_core/soft_shadows/occluder_edges.h"

#include <gtest/gtest.h>

#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

OccluderEdges edgesOf(const Mesh& mesh) {
  return occluderEdges(mesh, LightFrame(test::lightAbove()));
}

TEST(OccluderEdges, ofAPlateAreItsRim) {
  const OccluderEdges edges = edgesOf(test::plate(-1, 1, -1, 1, 2));
  EXPECT_EQ(edges.rims.size(), 4u);
  EXPECT_TRUE(edges.folds.empty()) << "the diagonal is seen by no one";
}

TEST(OccluderEdges, ofABoxAreItsTwelve) {
  Mesh box;
  append(box, makeBox({0.3f, 0.2f, 0.1f}), glm::translate(glm::mat4(1), {0, 1, 0}));
  const OccluderEdges edges = edgesOf(box);
  EXPECT_TRUE(edges.rims.empty());
  EXPECT_EQ(edges.folds.size(), 12u);
  // From straight below only the sides of the bottom are outlines: six edges from elsewhere.
  const auto outlines = [&](const glm::vec3& point) {
    size_t count = 0;
    for (const OccluderEdge& edge : edges.folds) {
      count += weightOf(edge, edges.planes, LightFrame(test::lightAbove()).fromWorld(point)) != 0;
    }
    return count;
  };
  EXPECT_EQ(outlines({0, 0, 0}), 4u);
  EXPECT_EQ(outlines({5, 0.1f, 7}), 6u);
}

// However triangles are turned: two that continue each other have no outline between them.
TEST(OccluderEdges, askNotHowTrianglesAreTurned) {
  Mesh plate = test::plate(-1, 1, -1, 1, 2);
  std::swap(plate.triangles[1].x, plate.triangles[1].y);
  EXPECT_EQ(edgesOf(plate).rims.size(), 4u);
  const OccluderEdges edges = edgesOf(plate);
  for (const OccluderEdge& edge : edges.folds) {
    EXPECT_EQ(weightOf(edge, edges.planes, {0.3f, 0.2f, 3}), 0);
  }
}

// Triangles without an edge between them face every point alike, also one in their plane.
TEST(OccluderEdges, ofOnePlaneShareIt) {
  for (const OccluderEdge& edge : edgesOf(test::plate(-1, 1, -1, 1, 2)).rims) {
    EXPECT_EQ(edge.plane, 0u);
  }
}

TEST(OccluderEdges, areOfWhatLiesInFrontOfTheLight) {
  EXPECT_TRUE(edgesOf(test::plate(-1, 1, -1, 1, 5)).mesh.triangles.empty());
  // An upright plate through the plane of the light, cut there.
  Mesh upright;
  append(upright, test::plate(-1, 1, -1, 1, 0),
         glm::rotate(glm::translate(glm::mat4(1), {3, 4, 0}), 1.5707963f, glm::vec3(0, 0, 1)));
  const OccluderEdges edges = edgesOf(upright);
  Box box;
  for (const OccluderEdge& edge : edges.rims) {
    box.add(edge.a);
    box.add(edge.b);
  }
  EXPECT_NEAR(box.lower.z, 0, 2e-5f);
  EXPECT_NEAR(box.upper.z, 1, 1e-5f);
  EXPECT_FALSE(edges.mesh.triangles.empty());
}

// Three triangles at one edge: a pair, and a rim.
TEST(OccluderEdges, takeManyTrianglesInPairs) {
  Mesh book;
  book.positions = {{0, 1, 0}, {0, 2, 0}, {1, 1.5f, 0}, {-1, 1.5f, 0.3f}, {0.2f, 1.5f, 1}};
  book.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  const OccluderEdges edges = edgesOf(book);
  EXPECT_EQ(edges.folds.size(), 1u);
  EXPECT_EQ(edges.rims.size(), 7u);
}

}  // namespace
}  // namespace ocelli
