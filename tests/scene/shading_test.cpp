#include "oc_core/scene/shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

TEST(LambertShade, IsNeverBlackAndNeverAboveOne) {
  const Mesh sphere = makeSphere(64);
  float least = 1;
  float most = 0;
  for (const glm::vec3& normal : sphere.positions) {
    least = std::min(least, lambertShade(normal));
    most = std::max(most, lambertShade(normal));
  }
  EXPECT_GT(least, 0.15f);
  EXPECT_LE(most, 1.0f);
  EXPECT_GT(most, 3 * least) << "without contrast nothing can be told apart";
}

TEST(BakeLambert, LightsASmoothSphereByItsRadius) {
  Mesh sphere = makeSphere(128);
  const Mesh bare = sphere;
  bakeLambert(sphere);
  ASSERT_EQ(sphere.positions.size(), bare.positions.size()) << "a smooth surface has no crease to split";
  for (size_t i = 0; i < bare.positions.size(); ++i) {
    // The normal of a vertex is that of the sphere up to the tessellation, 2 pi / 128 / 2 = 0.025 radians.
    EXPECT_NEAR(sphere.colors[i].x, lambertShade(glm::normalize(bare.positions[i])), 0.025f);
  }
}

TEST(BakeLambert, SplitsABoxIntoCrispFaces) {
  Mesh box = makeBox(glm::vec3(1));
  bakeLambert(box);
  ASSERT_EQ(box.positions.size(), 24u);
  ASSERT_EQ(box.triangles.size(), 12u);
  for (const glm::uvec3& t : box.triangles) {
    const glm::vec3 normal =
        glm::normalize(glm::cross(box.positions[t.y] - box.positions[t.x], box.positions[t.z] - box.positions[t.x]));
    for (glm::length_t i = 0; i < 3; ++i) {
      EXPECT_FLOAT_EQ(box.colors[t[i]].x, lambertShade(normal));
    }
  }
}

TEST(BakeLambert, MultipliesTheColorThatIsThere) {
  Mesh white = makeSphere(16);
  Mesh painted = white;
  paint(painted, {0.5f, 0.25f, 0.0f});
  bakeLambert(white);
  bakeLambert(painted);
  for (size_t i = 0; i < white.colors.size(); ++i) {
    EXPECT_FLOAT_EQ(painted.colors[i].x, 0.5f * white.colors[i].x);
    EXPECT_FLOAT_EQ(painted.colors[i].y, 0.25f * white.colors[i].y);
    EXPECT_EQ(painted.colors[i].z, 0.0f);
  }
}

TEST(BakeLambert, LeavesNothingBlackWhereTheWindingIsMixed) {
  Mesh sphere = makeSphere(32);
  for (size_t i = 0; i < sphere.triangles.size(); i += 3) {
    std::swap(sphere.triangles[i].y, sphere.triangles[i].z);
  }
  bakeLambert(sphere);
  for (const glm::vec3& color : sphere.colors) {
    EXPECT_GT(color.x, 0.15f);
    EXPECT_LE(color.x, 1.0f);
  }
}

TEST(BakeLambert, SurvivesTrianglesWithoutAnArea) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 1, 1}};
  bakeLambert(mesh);
  ASSERT_EQ(mesh.positions.size(), 4u) << "a face without an area makes no crease";
  EXPECT_FLOAT_EQ(mesh.colors[2].x, 1.0f) << "no other face is there to light it";
  EXPECT_FLOAT_EQ(mesh.colors[3].x, lambertShade({0, 0, 1}));
}

}  // namespace
}  // namespace ocelli
