#include "oc_core/worlds/solids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/teapot.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

TEST(Solids, BoxIsClosedAndHasItsVolume) {
  const Mesh box = makeBox({1, 2, 3});
  EXPECT_TRUE(isClosed(box));
  EXPECT_DOUBLE_EQ(signedVolume(box), 48.0);
}

TEST(Solids, SphereIsClosedAtAnyTessellation) {
  for (const int segments : {3, 4, 5, 16, 127}) {
    const Mesh sphere = makeSphere(segments);
    EXPECT_TRUE(isClosed(sphere)) << segments;
    EXPECT_GT(signedVolume(sphere), 0.0) << segments;
    for (const glm::vec3& position : sphere.positions) {
      EXPECT_NEAR(glm::length(position), 1.0f, 1e-6f);
    }
  }
  // The volume converges with the square of the step; at 256 segments it lacks (2 pi / 256)^2 / 4 of the whole at most.
  EXPECT_NEAR(signedVolume(makeSphere(256)), 4 * kPi / 3, 4 * kPi / 3 * 6.1e-4);
}

TEST(Solids, TorusIsClosedAndHasItsVolume) {
  for (const int segments : {3, 7, 64}) {
    EXPECT_TRUE(isClosed(makeTorus(0.3f, segments))) << segments;
  }
  // 2 pi^2 R r^2, less than (2 pi / 128)^2 off.
  const double volume = 2 * kPi * kPi * 0.7 * 0.3 * 0.3;
  EXPECT_NEAR(signedVolume(makeTorus(0.3f, 256)), volume, volume * 2.5e-3);
}

TEST(Solids, TurnedProfileIsClosedAndHasItsVolume) {
  for (const int segments : {3, 4, 33}) {
    const Mesh cone = makeTurned({{0, 0}, {2, 0}, {0, 3}}, segments);
    EXPECT_TRUE(isClosed(cone));
    // A pyramid over a regular polygon: n/2 r^2 sin(2 pi / n) h / 3.
    const double volume = segments / 2.0 * 4 * std::sin(2 * kPi / segments);
    EXPECT_NEAR(signedVolume(cone), volume, volume * 1e-6);
  }
  const Mesh cylinder = makeTurned({{0, 1}, {1, 1}, {1, 2}, {0, 2}}, 4);
  EXPECT_TRUE(isClosed(cylinder));
  EXPECT_NEAR(signedVolume(cylinder), 2.0, 1e-6);
  EXPECT_EQ(cylinder.triangles.size(), 16u);
}

TEST(Solids, PrismIsClosedAndHasItsVolume) {
  const Mesh gable = makePrism({{-1, 0}, {1, 0}, {0, 2}}, 3);
  EXPECT_TRUE(isClosed(gable));
  EXPECT_DOUBLE_EQ(signedVolume(gable), 12.0);
  const Mesh pentagon = makePrism({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 1}}, 0.5f);
  EXPECT_TRUE(isClosed(pentagon));
  EXPECT_DOUBLE_EQ(signedVolume(pentagon), 3.0);
}

TEST(Teapot, HasThePublishedExtent) {
  const Box box = boundsOf(makeTeapot(32));
  // From the control points: the knob's top at 3.15, the bottom at 0, the handle's end at x = -3. The body's control
  // points reach 2, and its curve does too, where two patches meet.
  EXPECT_FLOAT_EQ(box.upper.y, 3.15f);
  EXPECT_FLOAT_EQ(box.lower.y, 0.0f);
  EXPECT_NEAR(box.lower.x, -3.0f, 0.01f);
  EXPECT_FLOAT_EQ(box.upper.z, 2.0f);
  EXPECT_FLOAT_EQ(box.lower.z, -2.0f);
}

TEST(Teapot, HasTwoTrianglesAQuadButAtThePoles) {
  for (const int segments : {1, 2, 8}) {
    // Eight patches, four of the knob and four of the bottom, have a side that is one point.
    EXPECT_EQ(makeTeapot(segments).triangles.size(), static_cast<size_t>(32 * 2 * segments * segments - 8 * segments));
  }
}

TEST(Teapot, IsOneSheetAcrossItsPatches) {
  // The body with rim and bottom, and the lid with its knob: seen from above at the middle of each side, faces look
  // out.
  const Mesh teapot = makeTeapot(8);
  for (const glm::uvec3& t : teapot.triangles) {
    const glm::vec3 centroid = (teapot.positions[t.x] + teapot.positions[t.y] + teapot.positions[t.z]) / 3.0f;
    const bool isBody = centroid.y > 0.3f && centroid.y < 2.0f && std::abs(centroid.z) > 1.0f;
    const glm::vec3 normal =
        glm::cross(teapot.positions[t.y] - teapot.positions[t.x], teapot.positions[t.z] - teapot.positions[t.x]);
    if (isBody) {
      EXPECT_GT(glm::dot(normal, glm::vec3(centroid.x, 0, centroid.z)), 0.0f);
    }
  }
}

}  // namespace
}  // namespace ocelli
