#include "oc_core/render/raycast.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

TEST(RayScene, firstTriangleAlongTheSegmentsIsHit) {
  Mesh mesh = test::wall(0, 1);  // triangles 0 and 1
  test::addWall(mesh, -1, 1);    // 2 and 3
  const RayScene scene(mesh);
  // Straight on, both walls: the nearer one.
  const Fragment near = scene.intersect({{0.5f, -0.5f, 3}, {0.5f, -0.5f, -3}});
  EXPECT_EQ(near.triangle, 0u);
  EXPECT_LT(glm::distance(positionOf(near, mesh), glm::vec3(0.5f, -0.5f, 0)), 1e-5f);
  // Around the first wall.
  const RayPath around{{0.5f, -0.5f, 3}, {2, 0, 1}, {2, 0, -0.5f}, {-0.5f, 0.5f, -1.5f}};
  const Fragment far = scene.intersect(around);
  ASSERT_TRUE(far.covered());
  EXPECT_GE(far.triangle, 2u);
  // Half way along the last segment.
  EXPECT_LT(glm::distance(positionOf(far, mesh), glm::vec3(0.75f, 0.25f, -1)), 1e-5f);
}

TEST(RayScene, whatLiesBeyondTheLastPointIsNotHit) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  EXPECT_FALSE(scene.intersect({{0.5f, 0, 3}, {0.5f, 0, 0.01f}}).covered());
  EXPECT_TRUE(scene.intersect({{0.5f, 0, 3}, {0.5f, 0, -0.01f}}).covered());
  EXPECT_FALSE(scene.intersect({{0.5f, 0, 3}}).covered());
  EXPECT_FALSE(scene.intersect({}).covered());
}

// A square of half side 1 in the plane z = 0.
TEST(RayScene, surfaceIsNearWithinItsDistance) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  const auto expectDistance = [&](const glm::vec3& point, float distance) {
    EXPECT_TRUE(scene.hasSurfaceNear(point, distance + 1e-4f)) << distance;
    EXPECT_FALSE(scene.hasSurfaceNear(point, distance - 1e-4f)) << distance;
  };
  expectDistance({0.2f, 0.3f, 0.5f}, 0.5f);
  expectDistance({0.2f, -0.3f, -0.5f}, 0.5f);
  expectDistance({2, 0.3f, 0}, 1);
  expectDistance({4, 0.3f, 4}, 5);
  expectDistance({2, 3, 2}, 3);
  EXPECT_TRUE(scene.hasSurfaceNear({0.5f, 0.5f, 0}, 1e-5f));
}

// Against points all over the triangles, 1/40 of a side apart.
TEST(RayScene, surfaceIsNearWherePointsOfItAre) {
  const Mesh mesh = test::randomTriangles(30, 5);
  const RayScene scene(mesh);
  std::mt19937 random(3);
  const auto next = [&] { return static_cast<float>(random() >> 8) / static_cast<float>(1 << 23) - 1; };
  size_t near = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 point{next(), next(), next()};
    constexpr float kReach = 0.12f;
    float least = 1e9f;
    for (const glm::uvec3& t : mesh.triangles) {
      for (int b = 0; b <= 40; ++b) {
        for (int c = 0; b + c <= 40; ++c) {
          const glm::vec3 q = mesh.positions[t.x] * (static_cast<float>(40 - b - c) / 40) +
                              mesh.positions[t.y] * (static_cast<float>(b) / 40) +
                              mesh.positions[t.z] * (static_cast<float>(c) / 40);
          least = std::min(least, glm::distance(q, point));
        }
      }
    }
    const bool found = scene.hasSurfaceNear(point, kReach);
    near += found;
    if (least <= kReach) {
      EXPECT_TRUE(found);
    }
    // A side is at most sqrt(12) long, so a point of the surface is within 0.09 of one of the points.
    if (found) {
      EXPECT_LE(least, kReach + 0.09f);
    }
  }
  EXPECT_GT(near, 20u);
  EXPECT_LT(near, 180u);
}

TEST(RayScene, trianglesWithoutAnAreaAreNearToo) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(RayScene(mesh).hasSurfaceNear({1.5f, 0.1f, 0}, 0.2f));
  EXPECT_FALSE(RayScene(mesh).hasSurfaceNear({1.5f, 0.3f, 0}, 0.2f));
  EXPECT_FALSE(RayScene(Mesh{}).hasSurfaceNear({0, 0, 0}, 10));
}

// A finely made unit ball: the ray through the middle meets it at depth 9, and its silhouette is where the default view
// ends: sin = 1 / 10. Off the middle, by the law of sines, at depth z with x^2 + (10 - z)^2 = 1 on the ray x = t z.
TEST(Raycast, ballHasItsAnalyticDepth) {
  const PinholeCamera camera = test::smallCamera();
  const Mesh ball = makeSphere(512);
  const FragmentImage image = raycast(camera, ball, RayScene(ball));
  for (int y = 0; y < test::kHeight; ++y) {
    for (int x = 0; x < test::kWidth; ++x) {
      const double du = (x + 0.5 - test::kWidth / 2.0) / camera.focalPixels();
      const double dv = (y + 0.5 - test::kHeight / 2.0) / camera.focalPixels();
      const double t2 = du * du + dv * dv;
      // (1 + t2) z^2 - 20 z + 99 = 0
      const double inside = 100 - 99 * (1 + t2);
      if (inside > 0.05) {
        ASSERT_TRUE(image(x, y).covered()) << x << " " << y;
        // Facets of 2 pi / 512 lie up to 1 - cos(pi / 512) = 2e-5 below the ball, times two the other way around, over
        // the cosine of incidence.
        EXPECT_NEAR(image(x, y).z, (10 - std::sqrt(inside)) / (1 + t2), 6e-5 / std::sqrt(inside));
      } else if (inside < -0.05) {
        EXPECT_FALSE(image(x, y).covered()) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
