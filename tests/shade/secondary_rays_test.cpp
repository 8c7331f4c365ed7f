#include "oc_core/shade/secondary_rays.h"

#include <gtest/gtest.h>

#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using test::smallCamera;

TEST(SecondaryRays, areReflectedByAMirror) {
  const ShadedScene scene = test::mirrorBeforeBox();
  const SecondaryRays rays = reflectedRays({scene, scene.mirrors}, smallCamera());
  // The image is 60 pixels high for 2.01 units: a mirror of one unit covers 30 by 30 pixels, less what the box hides.
  EXPECT_GT(rays.rays.size(), 750u);
  EXPECT_LT(rays.rays.size(), 900u);
  for (const SecondaryRay& ray : rays.rays) {
    EXPECT_NEAR(ray.origin.z, 0, 1e-6f);
    // What comes from (0, 0, 10) goes back as if it came from (0, 0, -10).
    EXPECT_LT(glm::distance(ray.direction, glm::normalize(ray.origin - glm::vec3(0, 0, -10))), 1e-5f);
  }
  EXPECT_EQ(rays.base(0, 0), shadeBackground()) << "beside the mirror nothing is seen";
}

TEST(SecondaryRays, passGlassOfNoOpticalDensityStraight) {
  ShadedScene scene;
  scene.lenses.push_back(test::specularObject(makeSphere(64), 1.0));
  const SecondaryRays rays = refractedRays({scene, scene.lenses}, smallCamera());
  EXPECT_GT(rays.rays.size(), 2500u);
  for (const SecondaryRay& ray : rays.rays) {
    const glm::vec3 incoming = glm::normalize(ray.origin - glm::vec3(0, 0, 10));
    EXPECT_LT(glm::distance(ray.direction, incoming), 2e-4f);
    EXPECT_LT(ray.origin.z, 0.1f) << "it leaves on the far side";
  }
}

// A ball of index n focuses parallel light at n / (2 (n - 1)) radii from its middle: rays near the axis cross it there.
TEST(SecondaryRays, areFocusedByABallOfGlass) {
  ShadedScene scene;
  scene.lenses.push_back(test::specularObject(makeSphere(512), 1.5));
  View view;
  view.eye = {0, 0, 2000};
  view.zFar = 1e4f;
  view.fovVerticalDegrees = 0.01;
  const SecondaryRays rays = refractedRays({scene, scene.lenses}, PinholeCamera(view, 40, 40));
  ASSERT_GT(rays.rays.size(), 1000u);
  size_t tested = 0;
  for (const SecondaryRay& ray : rays.rays) {
    const float aside = glm::length(glm::vec2(ray.direction));
    if (aside < 0.02f || aside > 0.08f) {
      continue;
    }
    ++tested;
    const float t = -glm::dot(glm::vec2(ray.origin), glm::vec2(ray.direction)) / (aside * aside);
    const glm::vec3 nearest = ray.origin + ray.direction * t;
    // Beside the facets' own angles of 0.7 degrees, which normals smooth.
    EXPECT_NEAR(nearest.z, -1.5f, 0.08f);
  }
  EXPECT_GT(tested, 100u);
}

TEST(SecondaryRays, comeToAnEndInsideOfAnOpenObject) {
  ShadedScene scene;
  scene.lenses.push_back(test::specularObject(test::wall(0, 0.5f)));
  for (const SecondaryRay& ray : refractedRays({scene, scene.lenses}, smallCamera()).rays) {
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-5f);
    EXPECT_LT(ray.direction.z, -0.9f);
  }
}

}  // namespace
}  // namespace ocelli
