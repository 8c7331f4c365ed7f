#include "oc_core/volume/volume_bricks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

ScalarVolume randomVolume(const glm::ivec3& size) {
  VolumeGrid grid;
  grid.size = size;
  Random random(7);
  std::vector<float> values(grid.voxelCount());
  std::ranges::generate(values, [&] { return random.inRange(-1, 1); });
  return {std::move(grid), std::move(values)};
}

/// By asking the field at each voxel that the definition names, and at the brick's corners.
void expectRangesOfTheField(const ScalarVolume& volume) {
  const VolumeBricks bricks(volume);
  constexpr int kEdge = VolumeBricks::kEdge;
  const glm::ivec3 last = volume.grid().size - 1;
  for (int c = 0; c < bricks.size().z; ++c) {
    for (int b = 0; b < bricks.size().y; ++b) {
      for (int a = 0; a < bricks.size().x; ++a) {
        const glm::ivec3 lower = kEdge * glm::ivec3(a, b, c);
        const glm::ivec3 upper = glm::min(lower + kEdge, last);
        double least = 1e9;
        double greatest = -1e9;
        for (int k = lower.z; k <= upper.z; ++k) {
          for (int j = lower.y; j <= upper.y; ++j) {
            for (int i = lower.x; i <= upper.x; ++i) {
              least = std::min(least, volume.valueAt({i, j, k}));
              greatest = std::max(greatest, volume.valueAt({i, j, k}));
            }
          }
        }
        const BrickRange& range = bricks.range({a, b, c});
        EXPECT_LE(range.least, least);
        EXPECT_GE(range.greatest, greatest);
        // Rounded to the next float at most.
        EXPECT_NEAR(range.least, least, 1e-7);
        EXPECT_NEAR(range.greatest, greatest, 1e-7);
      }
    }
  }
}

TEST(VolumeBricks, HoldTheRangeOfTheFieldInThem) {
  expectRangesOfTheField(randomVolume({40, 33, 18}));
  expectRangesOfTheField(randomVolume({17, 16, 1}));
  expectRangesOfTheField(randomVolume({1, 1, 2}));
}

TEST(VolumeBricks, CoverTheBox) {
  constexpr int kEdge = VolumeBricks::kEdge;
  const VolumeBricks bricks(randomVolume({kEdge + 1, kEdge + 2, 1}));
  EXPECT_EQ(bricks.size(), glm::ivec3(1, 2, 1));
}

TEST(VolumeBricks, RoundOutwards) {
  VolumeGrid grid;
  grid.size = {2, 1, 1};
  const auto voxels = std::make_shared<const std::vector<int32_t>>(std::vector<int32_t>{16777217, -16777217});
  const ScalarVolume volume(grid, VoxelType::kInt32, std::as_bytes(std::span(*voxels)), voxels);
  const BrickRange range = VolumeBricks(volume).range({0, 0, 0});
  EXPECT_LE(double(range.least), -16777217);
  EXPECT_GE(double(range.greatest), 16777217);
}

TEST(VolumeBricks, HaveTheValuesThatVoxelsMeanAlsoWhereTheScaleIsNegative) {
  VolumeGrid grid;
  grid.size = {3, 1, 1};
  const auto voxels = std::make_shared<const std::vector<uint8_t>>(std::vector<uint8_t>{1, 5, 200});
  const ScalarVolume volume(grid, VoxelType::kUint8, std::as_bytes(std::span(*voxels)), voxels, -2, 10);
  const BrickRange range = VolumeBricks(volume).range({0, 0, 0});
  EXPECT_EQ(range.least, -390);
  EXPECT_EQ(range.greatest, 8);
}

}  // namespace
}  // namespace ocelli
