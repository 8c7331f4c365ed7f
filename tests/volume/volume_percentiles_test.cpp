#include "oc_core/volume/volume_percentiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "oc_core/base/random.h"
#include "tests/volume/field_volume.h"

namespace ocelli {
namespace {

constexpr std::array kPercents{0.0, 1.0, 7.0, 50.0, 99.0, 100.0};

/// By sorting what all finite voxels mean.
std::vector<double> sortedPercentiles(const ScalarVolume& volume) {
  std::vector<double> values;
  const glm::ivec3& size = volume.grid().size;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        const double value = volume.valueAt({i, j, k});
        if (std::isfinite(value)) {
          values.push_back(value);
        }
      }
    }
  }
  std::ranges::sort(values);
  std::vector<double> percentiles;
  for (const double percent : kPercents) {
    const double below = std::ceil(percent * static_cast<double>(values.size()) / 100);
    percentiles.push_back(values[static_cast<size_t>(std::max(below, 1.0)) - 1]);
  }
  return percentiles;
}

/// Many voxels that differ little, some that are far away, of both signs where the type has two.
template <class Voxel>
void expectSorted(VoxelType type) {
  Random random(7);
  std::vector<Voxel> values(size_t{11} * 7 * 40);
  for (Voxel& value : values) {
    value = static_cast<Voxel>(random.below(120));
    if constexpr (std::is_floating_point_v<Voxel>) {
      value = value / 7 - 5;
    } else if constexpr (std::is_signed_v<Voxel>) {
      value = static_cast<Voxel>(value - 60);
    }
  }
  values[100] = std::numeric_limits<Voxel>::max();
  values[200] = std::numeric_limits<Voxel>::lowest();
  for (const double scale : {1.0, -0.5}) {
    const ScalarVolume volume = test::volumeOfVoxels<Voxel>({.size = {11, 7, 40}}, type, values, scale, 3);
    EXPECT_EQ(percentilesOf(volume, kPercents), sortedPercentiles(volume)) << nameOf(type) << " scale " << scale;
  }
}

TEST(VolumePercentiles, areThoseOfSortedVoxelsOfAnyType) {
  expectSorted<uint8_t>(VoxelType::kUint8);
  expectSorted<int8_t>(VoxelType::kInt8);
  expectSorted<uint16_t>(VoxelType::kUint16);
  expectSorted<int16_t>(VoxelType::kInt16);
  expectSorted<uint32_t>(VoxelType::kUint32);
  expectSorted<int32_t>(VoxelType::kInt32);
  expectSorted<float>(VoxelType::kFloat32);
  expectSorted<double>(VoxelType::kFloat64);
}

TEST(VolumePercentiles, leaveOutWhatIsNoNumber) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  VolumeGrid grid;
  grid.size = {5, 1, 1};
  const ScalarVolume some(grid, {none, 4, -infinity, infinity, -2});
  EXPECT_EQ(percentilesOf(some, kPercents), (std::vector<double>{-2, -2, -2, -2, 4, 4}));
  EXPECT_EQ(percentilesOf({grid, std::vector<float>(5, none)}, kPercents), std::vector<double>(6, 0.0));
}

}  // namespace
}  // namespace ocelli
