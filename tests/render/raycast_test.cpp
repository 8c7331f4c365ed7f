#include "oc_core/render/raycast.h"

#include <gtest/gtest.h>

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
