// Coarser volumes in 16 bits of a range of values: what is finer than a display can show.
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "oc_core/volume/volume_levels.h"

namespace ocelli {
namespace {

TEST(AveragedInRange, AveragesWhatItCoversAlsoAtAnOddEnd) {
  VolumeGrid grid;
  grid.size = {5, 2, 3};
  std::vector<float> values(grid.voxelCount());
  std::iota(values.begin(), values.end(), 0.0f);
  const ScalarVolume fine(grid, values);
  const ScalarVolume coarse = averagedInRange(fine, {2, 1, 3}, valueRange(fine));
  ASSERT_EQ(coarse.grid().size, glm::ivec3(3, 2, 1));
  const double halfStep = 29.0 / 65535 / 2;
  EXPECT_NEAR(coarse.valueAt({0, 1, 0}), (5 + 6 + 15 + 16 + 25 + 26) / 6.0, 1.001 * halfStep);
  EXPECT_NEAR(coarse.valueAt({2, 0, 0}), (4 + 14 + 24) / 3.0, 1.001 * halfStep);
}

TEST(AveragedInRange, StaysWhereItWas) {
  // The field is its own x, and an average of a linear field is that of the middle.
  VolumeGrid grid;
  grid.size = {8, 4, 4};
  grid.worldFromIndex[0][0] = 0.25;
  grid.worldFromIndex[3][0] = 7;
  std::vector<float> values;
  for (size_t i = 0; i < grid.voxelCount(); ++i) {
    values.push_back(7 + 0.25f * static_cast<float>(i % 8));
  }
  const ScalarVolume fine(grid, values);
  const ScalarVolume coarse = averagedInRange(fine, {4, 2, 2}, valueRange(fine));
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(coarse.valueAt({i, 1, 1}), (coarse.grid().worldFromIndex * glm::dvec4(i, 1, 1, 1)).x, 1.75 / 65535);
  }
}

TEST(AveragedInRange, HasTheValuesThatVoxelsMean) {
  VolumeGrid grid;
  grid.size = {2, 2, 2};
  const auto voxels = std::make_shared<std::vector<int16_t>>(std::vector<int16_t>{0, 1, 2, 3, 4, 5, 6, 7});
  const ScalarVolume volume(grid, VoxelType::kInt16, std::as_bytes(std::span(*voxels)), voxels, 2, -1000);
  EXPECT_NEAR(averagedInRange(volume, glm::ivec3(2), valueRange(volume)).valueAt({0, 0, 0}), 2 * 3.5 - 1000,
              14.0 / 65535);
}

TEST(AveragedInRange, OfAnEvenVolumeIsEven) {
  VolumeGrid grid;
  grid.size = {4, 4, 4};
  const ScalarVolume volume(grid, std::vector<float>(64, -7.0f));
  EXPECT_EQ(averagedInRange(volume, glm::ivec3(2), valueRange(volume)).valueAt({1, 0, 1}), -7);
}

}  // namespace
}  // namespace ocelli
