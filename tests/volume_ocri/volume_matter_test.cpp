#include "oc_core/volume_ocri/volume_matter.h"

#include <gtest/gtest.h>

#include "tests/volume_ocri/block_volumes.h"

namespace ocelli {
namespace {

TEST(VolumeMatter, IsWhereARayThroughAllOfItWouldBeHit) {
  // One value, whose extinction over the diagonal of the cube, 2 sqrt(3), leaves half of the light but for the factor.
  const double diagonal = 2 * std::sqrt(3.0);
  for (const double factor : {0.99, 1.01}) {
    VolumeScene scene = test::sceneOfBlocks({});
    const double opacity = 1 - std::exp(-std::log(2.0) * factor);
    scene.appearance.transfer = TransferFunction({{0, glm::dvec3(1), opacity}}, diagonal);
    EXPECT_EQ(VolumeMatter(scene, 0.5).isClearAt(glm::dvec3(0)), factor < 1);
  }
}

TEST(VolumeMatter, OutsideOfTheBoxAndBeforeAClipPlaneAllIsClear) {
  VolumeScene scene = test::sceneOfBlocks({{{0, 0, 0}, {64, 64, 64}}});
  EXPECT_FALSE(VolumeMatter(scene, 0.5).isClearAt({0.99, 0, 0}));
  EXPECT_TRUE(VolumeMatter(scene, 0.5).isClearAt({1.01, 0, 0}));
  scene.clips.push_back({{0, 0, 1}, 0.5});
  EXPECT_FALSE(VolumeMatter(scene, 0.5).isClearAt({0, 0, 0.51}));
  EXPECT_TRUE(VolumeMatter(scene, 0.5).isClearAt({0, 0, 0.49}));
}

TEST(VolumeMatter, BehindAHitARayBeginsInTheClear) {
  const VolumeScene scene = test::blockBeforeWall();
  const VolumeMatter matter(scene, 0.5);
  const RayPath ray{{0.1f, 0.1f, 3}, {0.1f, 0.1f, 0.4f}, {0.1f, 0.1f, -3}};
  const RayPath rest = matter.behind(ray, 2.5f);  // where z is 0.5
  ASSERT_EQ(rest.size(), 2u);
  // The block ends at z = 0.25; places are half a voxel apart, and the field falls within a voxel.
  EXPECT_LE(rest.front().z, 0.25f);
  EXPECT_GE(rest.front().z, 0.25f - 1.5f * test::kBlocksSpacing);
  EXPECT_NEAR(rest.tMin(), 3 - rest.front().z, 1e-5f);
  EXPECT_EQ(rest.back(), ray.back());
  EXPECT_EQ(rest.tMax(), ray.tMax());
}

TEST(VolumeMatter, BehindTheLastMatterThereMayBeNothing) {
  const VolumeScene scene = test::blockBeforeWall();
  const VolumeMatter matter(scene, 0.5);
  // Both end in the wall.
  EXPECT_TRUE(matter.behind({{0.1f, 0.1f, 3}, {0.1f, 0.1f, -0.6f}}, 3.55f).empty());
  EXPECT_TRUE(matter.behind({}, 0).empty());
}

TEST(VolumeMatter, IsNearWithinTheReach) {
  const VolumeScene scene = test::blockBeforeWall();
  const VolumeMatter matter(scene, 0.5);
  // The front of the block is at z = 0.5, the outermost centres of its voxels half a voxel behind it.
  EXPECT_TRUE(matter.isNear({0, 0, 0.4f}, 1e-3f));
  EXPECT_TRUE(matter.isNear({0, 0, 0.6f}, 0.1f + test::kBlocksSpacing));
  EXPECT_FALSE(matter.isNear({0, 0, 0.6f}, 0.1f - test::kBlocksSpacing));
  EXPECT_FALSE(matter.isNear({0, 0, 5}, 1));
}

TEST(VolumeMatter, SurfacesInsideAreNearToo) {
  VolumeScene scene = test::sceneOfBlocks({});
  scene.surfaces.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, 0.5f, 0}};
  scene.surfaces.triangles = {{0, 1, 2}};
  const VolumeMatter matter(scene, 0.5);
  EXPECT_TRUE(matter.isNear({0, 0, 0.1f}, 0.11f));
  EXPECT_FALSE(matter.isNear({0, 0, 0.1f}, 0.09f));
}

}  // namespace
}  // namespace ocelli
