#include "oc_core/volume_camera/first_hit_mesh.h"

#include <gtest/gtest.h>

#include "oc_core/volume_render/volume_target.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

TEST(FirstHitMesh, LiesOnWhatIsOpaque) {
  const VolumeRenderer renderer(ballVolume());
  const Mesh mesh = firstHitMesh(VolumeTarget(renderer), PinholeCamera(View{}, 60, 40), 1.6f);
  ASSERT_FALSE(mesh.empty());
  EXPECT_TRUE(mesh.isPart);
  float nearest = 1;
  float farthest = 0;
  for (const glm::vec3& point : mesh.positions) {
    nearest = std::min(nearest, glm::length(point));
    farthest = std::max(farthest, glm::length(point));
  }
  // Rays stop within half a step (1/32) and the slab that hides (0.01); squares of grazing samples stand out by about a
  // pixel, which is 1/20 here, or more where they are steep.
  EXPECT_GT(nearest, 0.5 - 1.0 / 32 - 0.01);
  EXPECT_LT(farthest, 0.5 + 0.15);
}

TEST(FirstHitMesh, SeesFartherAroundFromTheCornersOfALargerCell) {
  const VolumeRenderer renderer(ballVolume());
  const VolumeTarget target(renderer);
  const auto farthestBack = [&](float cell) {
    // Behind the ball's middle, as seen from the eye: what only corners see.
    float lowest = 1;
    for (const glm::vec3& point : firstHitMesh(target, PinholeCamera(View{}, 120, 80), cell).positions) {
      lowest = std::min(lowest, point.z);
    }
    return lowest;
  };
  EXPECT_LT(farthestBack(6), farthestBack(0.5f) - 0.05f);
}

TEST(FirstHitMesh, OfNothingIsEmpty) {
  const VolumeRenderer renderer(ballVolume());
  const PinholeCamera away(View{.target = {0, 0, 20}, .fovVerticalDegrees = 30}, 30, 20);
  EXPECT_TRUE(firstHitMesh(VolumeTarget(renderer), away, 1.6f).empty());
}

}  // namespace
}  // namespace ocelli::test
