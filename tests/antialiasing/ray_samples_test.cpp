#include "oc_core/antialiasing/ray_samples.h"

#include <gtest/gtest.h>

#include "tests/antialiasing/antialias_scenes.h"

namespace ocelli::test {
namespace {

TEST(RaySamples, oneRayAPixelIsRaycasting) {
  const PinholeCamera camera({}, 45, 30);
  const Mesh mesh = triangleCloud(2000, 0.05f);
  const RayScene rays(mesh);
  const SamplePattern one(1, *findSamplePlacement("grid"));
  const Image<glm::vec3> image = raySampledImage(
      45, 30, [&](const glm::vec2& p) { return camera.rayPath(p); }, rays, one, kNight);
  EXPECT_EQ(image, colorImage(raycast(camera, mesh, rays), mesh, kNight));
}

TEST(RaySamples, emptyPathsSeeTheBackground) {
  const Mesh mesh = triangleCloud(10, 0.05f);
  const SamplePattern pattern(3, *findSamplePlacement("jittered"));
  const Image<glm::vec3> image = raySampledImage(
      5, 4, [](const glm::vec2&) { return RayPath{}; }, RayScene(mesh), pattern, kNight);
  for (const glm::vec3& each : image) {
    EXPECT_NEAR(glm::distance(each, kNight), 0, 1e-6);
  }
}

}  // namespace
}  // namespace ocelli::test
