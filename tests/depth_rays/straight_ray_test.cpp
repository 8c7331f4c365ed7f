#include "oc_core/depth_rays/straight_ray.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

constexpr glm::vec3 kA{0, 0, 0};
constexpr glm::vec3 kB{4, 0, 0};
constexpr glm::vec3 kC{0, 4, 0};

TEST(StraightRay, meetsATriangleWhereItIs) {
  const auto meeting = meetTriangle({{1, 2, 5}, {0, 0, -10}, 1}, kA, kB, kC, 7);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->share, 0.5);
  EXPECT_EQ(meeting->triangle, 7u);
  EXPECT_EQ(meeting->b1, 0.25f);
  EXPECT_EQ(meeting->b2, 0.5f);
  const auto behind = meetTriangle({{1, 2, -5}, {0, 0, 10}, 1}, kA, kB, kC, 7);
  ASSERT_TRUE(behind) << "from the other side";
  EXPECT_EQ(behind->share, 0.5);
}

TEST(StraightRay, endsWhereItEnds) {
  EXPECT_TRUE(meetTriangle({{1, 1, 5}, {0, 0, -5}, 1}, kA, kB, kC, 0)) << "just there";
  EXPECT_FALSE(meetTriangle({{1, 1, 5}, {0, 0, -4}, 1}, kA, kB, kC, 0));
  EXPECT_TRUE(meetTriangle({{1, 1, 5}, {0, 0, -4}, 2}, kA, kB, kC, 0));
  EXPECT_FALSE(meetTriangle({{1, 1, 5}, {0, 0, 5}, 1}, kA, kB, kC, 0)) << "behind its origin";
  EXPECT_TRUE(meetTriangle({{1, 1, 0}, {0, 0, 5}, 1}, kA, kB, kC, 0)) << "which is on the triangle";
}

TEST(StraightRay, meetsNothingInItsOwnPlaneNorATriangleWithoutArea) {
  EXPECT_FALSE(meetTriangle({{-1, 1, 0}, {9, 0, 0}, 1}, kA, kB, kC, 0));
  EXPECT_FALSE(meetTriangle({{1, 0, 5}, {0, 0, -9}, 1}, kA, kB, {2, 0, 0}, 0));
}

// A fan around a point, hit on its edges and at its middle: no ray passes between two triangles.
TEST(StraightRay, passesBetweenNoTwoTriangles) {
  constexpr int kRim = 7;
  std::vector<glm::vec3> rim;
  for (int i = 0; i < kRim; ++i) {
    const auto angle = static_cast<float>(6.283185307 * i / kRim);
    rim.emplace_back(std::cos(angle), std::sin(angle), 0.1f * static_cast<float>(i % 3));
  }
  const glm::vec3 middle(0.01f, -0.02f, 0.05f);
  Random random(3);
  for (int k = 0; k < 20000; ++k) {
    const glm::vec3 origin(random.inRange(-3, 3), random.inRange(-3, 3), random.inRange(1, 4));
    const glm::vec3& end = rim[random.below(kRim)];
    const glm::vec3 aim = middle + (end - middle) * random.inRange(0, 0.95f);
    const StraightRay ray{origin, (aim - origin) * 2.0f, 1};
    int met = 0;
    for (size_t i = 0; i < kRim; ++i) {
      met += meetTriangle(ray, middle, rim[i], rim[(i + 1) % kRim], 0).has_value();
    }
    EXPECT_GE(met, 1);
  }
}

TEST(StraightRay, aDirectionIsLongEnoughToBeOne) {
  EXPECT_TRUE((StraightRay{{}, {0, 1e-14f, 0}}.hasDirection()));
  EXPECT_FALSE((StraightRay{{}, {0, 1e-16f, 0}}.hasDirection()));
  EXPECT_FALSE((StraightRay{{}, {0, 0, 0}}.hasDirection()));
}

}  // namespace
}  // namespace ocelli
