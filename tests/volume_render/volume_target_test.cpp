#include "oc_core/volume_render/volume_target.h"

#include <gtest/gtest.h>

#include "tests/camera/test_curved_cameras.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

TEST(VolumeTarget, isHitWhereTheOpacityReachesTheThreshold) {
  VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5));
  const VolumeRenderer renderer(scene, {.depthOpacity = 0.75});
  const VolumeTarget target(renderer);
  const std::optional<Hit> hit = target.hit({{0.1f, 0.2f, 10}, {0.1f, 0.2f, -10}});
  ASSERT_TRUE(hit);
  // A length of 0.5 keeps a half, so two of them a quarter: at z = 0.
  EXPECT_NEAR(hit->t, 10, 1e-4f);
  EXPECT_NEAR(hit->position.z, 0, 1e-4f);
  EXPECT_NEAR(hit->color.r, 0.8f, 1e-5f);
  EXPECT_EQ(hit->element, VolumeTarget::kVolume);
  EXPECT_FALSE(target.hit({{1.2f, 0.2f, 10}, {1.2f, 0.2f, -10}}));
  EXPECT_FALSE(target.hit({{0.1f, 0.2f, 10}, {0.1f, 0.2f, 0.1f}})) << "it ends before the threshold is reached";
  EXPECT_NEAR(target.bounds().upper.x, 1, 1e-6f);
}

TEST(VolumeTarget, whatLiesBeyondTheThresholdHasNoPartInTheColor) {
  // Red to z = 0.5, green beyond: by slices of values. 0.5 keeps a half.
  const TransferFunction colors(
      {{0, {0, 1, 0}, 0.5}, {14.4, {0, 1, 0}, 0.5}, {14.6, {1, 0, 0}, 0.5}, {19, {1, 0, 0}, 0.5}}, 0.5);
  const VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](const glm::dvec3& p) { return p.z; }, colors);
  const VolumeRenderer red(scene, {.depthOpacity = 0.4});
  const std::optional<Hit> hit = VolumeTarget(red).hit({{0.1f, 0.2f, 10}, {0.1f, 0.2f, -10}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->color.r, 1, 1e-5f);
  EXPECT_NEAR(hit->color.g, 0, 1e-5f);
  // Three quarters: a half of red and a quarter of green. The colours mix over 0.02 around z = 0.5, and the step is
  // 0.05: an error of 1e-2 of the share that it absorbs.
  const VolumeRenderer both(scene, {.depthOpacity = 0.75});
  const std::optional<Hit> deeper = VolumeTarget(both).hit({{0.1f, 0.2f, 10}, {0.1f, 0.2f, -10}});
  ASSERT_TRUE(deeper);
  EXPECT_NEAR(deeper->color.r, 2.0f / 3, 2e-3f);
  EXPECT_NEAR(deeper->color.g, 1.0f / 3, 2e-3f);
}

TEST(VolumeTarget, surfacesAreHitToo) {
  VolumeScene scene = test::floatVolume(
      glm::ivec3(20), 0.1, [](auto) { return 1; }, test::everywhere(0.5, 0.5, {1, 0, 0}));
  scene.surfaces = test::wall(0.5f);
  const VolumeRenderer renderer(scene, {.depthOpacity = 0.75});
  const VolumeTarget target(renderer);
  const std::optional<Hit> hit = target.hit({{0.1f, 0.2f, 10}, {0.1f, 0.2f, -10}});
  ASSERT_TRUE(hit);
  // Rays of Embree are in single precision, 20 long.
  EXPECT_NEAR(hit->t, 9.5f, 1e-4f);
  EXPECT_EQ(hit->element, VolumeTarget::kSurface);
  // Half of the slab's red before the wall's grey.
  EXPECT_NEAR(hit->color.r, 0.5f + 0.5f * 0.5f, 1e-4f);
  EXPECT_NEAR(hit->color.g, 0.25f, 1e-4f);
  EXPECT_NEAR(target.bounds().upper.x, 3, 1e-6f) << "the wall is wider than the volume";
}

TEST(VolumeTarget, castsAsAnyTargetDoes) {
  const VolumeRenderer renderer(test::waves());
  const VolumeTarget target(renderer);
  const CurvedRayCamera camera = test::bendingTwice();
  const HitImage seen = castRays(camera, target);
  const VolumeImage image = renderVolume(camera, renderer);
  size_t hits = 0;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      ASSERT_EQ(seen(x, y).has_value(), std::isfinite(image(x, y).t));
      if (seen(x, y)) {
        ++hits;
        EXPECT_EQ(seen(x, y)->t, image(x, y).t);
        // On the ray of its pixel: arcs are 24 chords, 0.005 of a step in t off at most (camera_contract_test.cpp).
        const std::optional<ImagePoint> q = camera.project(seen(x, y)->position);
        ASSERT_TRUE(q);
        EXPECT_NEAR(q->u, static_cast<float>(x) + 0.5f, 0.05f);
        EXPECT_NEAR(q->v, static_cast<float>(y) + 0.5f, 0.05f);
      }
    }
  }
  EXPECT_GT(hits, 500u);
}

}  // namespace
}  // namespace ocelli
