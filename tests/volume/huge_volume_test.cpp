// A volume of 64 GB, in a sparse file: what stands for it is made without it ever being in memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume/volume_levels.h"
#include "oc_core/volume/voxel_survey.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume/sparse_volume.h"

namespace ocelli {
namespace {

constexpr size_t kMaxResidentBytes = size_t{2} << 30U;

size_t peakResidentBytes() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<size_t>(usage.ru_maxrss) * 1024;
}

TEST(HugeVolume, isStoodForByALevelInLittleMemory) {
  const test::TemporaryFolder folder;
  // 18 of 3200 slices hold voxels: 369 MB.
  const test::SparseVolume file(folder.path(), {3200, 3200, 3200}, 1600, 1618);
  if (!file.isSparse()) {
    GTEST_SKIP() << "this disk keeps no holes";
  }
  const auto whole = std::make_shared<const ScalarVolume>(file.map());
  EXPECT_GE(whole->voxels().size(), size_t{64'000'000'000});
  const VolumeLevel level = levelFor(whole, {});
  EXPECT_EQ(level.factor, 5);
  EXPECT_FALSE(level.isSampled) << "what is no hole is quickly read";
  EXPECT_EQ(level.volume->valueAt({100, 100, 319}), 0);
  EXPECT_EQ(level.volume->valueAt({100, 100, 320}), test::SparseVolume::kSlabValue);
  // Slices 1615 to 1617, of 1615 to 1619.
  EXPECT_EQ(level.volume->valueAt({639, 639, 323}), test::SparseVolume::kSlabValue * 3 / 5);
  EXPECT_EQ(sampledLevel(*whole, 8).valueAt({5, 5, 201}), test::SparseVolume::kSlabValue);
  const ValueRange range = surveyVoxels(*whole).range;
  EXPECT_EQ(range.greatest, test::SparseVolume::kSlabValue);
  const VolumeBricks bricks(*whole);
  EXPECT_EQ(bricks.range({3, 4, 1608 / VolumeBricks::kEdge}).greatest, test::SparseVolume::kSlabValue);
  EXPECT_EQ(bricks.range({3, 4, 1632 / VolumeBricks::kEdge}).greatest, 0);
  EXPECT_LT(peakResidentBytes(), kMaxResidentBytes);
}

}  // namespace
}  // namespace ocelli
