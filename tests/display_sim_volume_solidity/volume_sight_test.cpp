#include "display_sim/volume_solidity/volume_sight.h"

#include <gtest/gtest.h>

#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

/// An even cube of the half side 0.5 that keeps half of the light over a length of 0.1.
VolumeScene evenCube() {
  return test::sceneOfField(
      16, 0.5, [](const glm::dvec3&) { return 1.0; }, TransferFunction({{0, {1, 1, 1}, 0.5}}, 0.1));
}

TEST(VolumeSight, EndsWhereTheOpacityIsReached) {
  // From far in front the front face lies at z = 0.5; a quarter of the light is left 0.2 behind it.
  const VolumeRenderer renderer(evenCube(), {.depthOpacity = 0.75});
  const VolumeSight sight(renderer, {glm::vec3(0, 0, 10)}, 64);
  constexpr double kSide = 0.01;
  for (const double x : {-0.3, 0.0, 0.2}) {
    EXPECT_TRUE(sight.sees({x, 0.1, 0.45}, kSide));
    EXPECT_TRUE(sight.sees({x, 0.1, 0.32}, kSide));
    EXPECT_FALSE(sight.sees({x, 0.1, 0.26}, kSide));
    EXPECT_FALSE(sight.sees({x, 0.1, -0.4}, kSide));
    // A larger cell reaches farther: a voxel and a half.
    EXPECT_TRUE(sight.sees({x, 0.1, 0.26}, 0.04));
  }
  // Beside the cube nothing hides.
  EXPECT_TRUE(sight.sees({0.8, 0, -0.4}, kSide));
}

TEST(VolumeSight, OfSeveralEyesIsWhatOneOfThemSees) {
  const VolumeRenderer renderer(evenCube(), {.depthOpacity = 0.5});
  const VolumeSight sight(renderer, {glm::vec3(0, 0, 10), glm::vec3(10, 0, 0)}, 64);
  EXPECT_TRUE(sight.sees({0.1, 0, 0.45}, 0.01));
  EXPECT_TRUE(sight.sees({0.45, 0, 0.1}, 0.01));
  EXPECT_FALSE(sight.sees({-0.45, 0, 0.1}, 0.01));
  EXPECT_FALSE(sight.sees({0, 0, 0}, 0.01));
}

TEST(VolumeSight, SeesThroughWhatIsThin) {
  VolumeScene scene = evenCube();
  scene.appearance.transfer = TransferFunction({{0, {1, 1, 1}, 0.01}}, 1);
  const VolumeRenderer renderer(scene, {.depthOpacity = 0.5});
  EXPECT_TRUE(VolumeSight(renderer, {glm::vec3(0, 0, 10)}, 32).sees({0, 0, -0.45}, 0.01));
}

TEST(VolumeSight, LooksStraightFromAbove) {
  const VolumeRenderer renderer(evenCube(), {.depthOpacity = 0.5});
  const VolumeSight sight(renderer, {glm::vec3(0, 10, 0)}, 64);
  EXPECT_TRUE(sight.sees({0.1, 0.45, 0.2}, 0.01));
  EXPECT_FALSE(sight.sees({0.1, 0, 0.2}, 0.01));
}

}  // namespace
}  // namespace ocelli
