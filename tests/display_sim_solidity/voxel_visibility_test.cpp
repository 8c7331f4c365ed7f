#include "display_sim/solidity/voxel_visibility.h"

#include <gtest/gtest.h>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

constexpr int kSlices = 60;
constexpr int kSide = 96;

// From (0, 0, d) the horizon of a sphere of radius R lies at z = R^2 / d. A point of the sphere behind it, at z, is
// reached through a chord that is at least 2 (R^2 / d - z) long, and it is hidden where that is longer than the reach.
// A voxel's centre is within half the diagonal of its cell of the surface.
TEST(VoxelVisibility, theFarSideOfASphereIsHidden) {
  constexpr double kRadius = 0.7;
  const DisplayProfile profile = test::smallProfile(kSlices, kSide, kSide);
  const Mesh sphere = test::sphere(kRadius, 80);
  const RayScene scene(sphere);
  const Volume volume = sliceExactly(sphere, profile);
  const Volume hidden = VoxelVisibility(volume, scene).hiddenFrom({0, 0, 10});
  const SweepGeometry sweep(profile);
  const double cell = std::hypot(sweep.columnWidth(), sweep.rowHeight(), kRadius * sweep.stepRadians());
  const double reach = kVoxelReach * std::max(sweep.columnWidth(), (kRadius + cell) * sweep.stepRadians());
  const double horizon = kRadius * kRadius / 10;
  size_t seen = 0;
  size_t notSeen = 0;
  for (int slice = 0; slice < volume.slices(); ++slice) {
    forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
      const double z = sweep.voxelCenter(slice, column, row).z;
      const bool isHidden = hidden.colorBits(slice, column, row) != 0;
      if (z > horizon + cell / 2) {
        EXPECT_FALSE(isHidden) << z;
        ++seen;
      } else if (z < horizon - cell / 2 - reach / 2) {
        EXPECT_TRUE(isHidden) << z;
        EXPECT_EQ(hidden.levels(slice, column, row), levels);
        ++notSeen;
      }
    });
  }
  EXPECT_GT(seen, volume.litVoxels() / 3);
  EXPECT_GT(notSeen, volume.litVoxels() / 3);
}

// The eye is a hand's breadth above the plane: rays meet it far before the centres of voxels that lie below it.
TEST(VoxelVisibility, aFloorSeenAtAGrazingAngleIsVisible) {
  Mesh floor;
  test::addTriangle(floor, {-9, 0.001f, -9}, {9, 0.001f, -9}, {0, 0.001f, 9});
  const RayScene scene(floor);
  const Volume volume = sliceExactly(floor, test::smallProfile(kSlices, kSide, kSide));
  ASSERT_GT(volume.litVoxels(), 0u);
  EXPECT_EQ(VoxelVisibility(volume, scene).hiddenFrom({0, 0.1f, 10}).litVoxels(), 0u);
}

// What floats before the scene, however wrong, hides nothing and is hidden by nothing; what lies within it is hidden.
TEST(VoxelVisibility, voxelsWithoutASurfaceStandForTheirCentres) {
  const DisplayProfile profile = test::smallProfile(kSlices, kSide, kSide);
  const Mesh box = test::box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  const RayScene scene(box);
  const Mesh before = test::sphere(0.1, 8, {0, 0, 0.8});
  const Mesh within = test::sphere(0.1, 8);
  for (const glm::vec3 eye : {glm::vec3(0, 0, 10), glm::vec3(1, 2, 9)}) {
    const Volume floating = sliceExactly(before, profile);
    EXPECT_EQ(VoxelVisibility(floating, scene).hiddenFrom(eye).litVoxels(), 0u);
    const Volume buried = sliceExactly(within, profile);
    EXPECT_EQ(VoxelVisibility(buried, scene).hiddenFrom(eye), buried);
  }
}

TEST(VoxelVisibility, isTheSameWithAnyNumberOfThreads) {
  const Mesh torus = test::torus(0.6, 0.3, 40, 30);
  const RayScene scene(torus);
  const Volume volume = sliceExactly(torus, test::smallProfile(kSlices, kSide, kSide, SecondHalfTurn::kOwn));
  setThreadCount(1);
  const Volume one = VoxelVisibility(volume, scene).hiddenFrom({0, 3, 9});
  setThreadCount(3);
  const Volume three = VoxelVisibility(volume, scene).hiddenFrom({0, 3, 9});
  setThreadCount(0);
  EXPECT_EQ(one, three);
  EXPECT_GT(one.litVoxels(), 0u);
  EXPECT_LT(one.litVoxels(), volume.litVoxels());
}

}  // namespace
}  // namespace ocelli
