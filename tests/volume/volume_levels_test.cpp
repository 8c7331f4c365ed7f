#include "oc_core/volume/volume_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/volume/volume_bricks.h"
#include "oc_core/volume/volume_histogram.h"
#include "oc_core/volume/voxel_survey.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume/sparse_volume.h"

namespace ocelli {
namespace {

ScalarVolume shortVolume(const glm::ivec3& size) {
  VolumeGrid grid;
  grid.size = size;
  grid.worldFromIndex = {{2, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 4, 0}, {5, 6, 7, 1}};
  Random random(3);
  auto voxels = std::make_shared<std::vector<int16_t>>(grid.voxelCount());
  std::ranges::generate(*voxels, [&] { return static_cast<int16_t>(random.below(2000)) - 1000; });
  ScalarVolume volume(grid, VoxelType::kInt16, std::as_bytes(std::span(*voxels)), voxels, 0.5, 3);
  volume.setFacts({.modality = "CT"});
  return volume;
}

TEST(VolumeLevels, areMeansOfTheVoxelsThatTheyStandFor) {
  const ScalarVolume whole = shortVolume({23, 9, 7});
  const int factor = 4;
  const ScalarVolume level = averagedLevel(whole, factor);
  EXPECT_EQ(level.grid().size, glm::ivec3(6, 3, 2));
  EXPECT_EQ(level.facts().modality, "CT");
  for (int c = 0; c < 2; ++c) {
    for (int b = 0; b < 3; ++b) {
      for (int a = 0; a < 6; ++a) {
        double sum = 0;
        int count = 0;
        for (int k = factor * c; k < std::min(factor * (c + 1), 7); ++k) {
          for (int j = factor * b; j < std::min(factor * (b + 1), 9); ++j) {
            for (int i = factor * a; i < std::min(factor * (a + 1), 23); ++i) {
              sum += whole.valueAt({i, j, k});
              ++count;
            }
          }
        }
        // Voxels are whole numbers, half of which is what they mean.
        EXPECT_NEAR(level.valueAt({a, b, c}), sum / count, 0.25 + 1e-9);
      }
    }
  }
}

/// Zeros that count how many of their bytes are in use.
class CountedZeros : public VoxelStore {
 public:
  explicit CountedZeros(size_t count) : bytes_(count) {}

  std::span<const std::byte> bytes() const override { return bytes_; }
  bool isKnownZero(size_t /*begin*/, size_t /*end*/) const override { return false; }
  size_t bytesToRead() const override { return bytes_.size(); }
  void willRead(size_t begin, size_t end) const override {
    used_ += end - begin;
    most_ = std::max(most_, used_);
    all_ += end - begin;
  }
  void release(size_t begin, size_t end) const override { used_ -= end - begin; }

  size_t used() const { return used_; }
  size_t most() const { return most_; }
  size_t all() const { return all_; }

 private:
  std::vector<std::byte> bytes_;
  // averagedLevel() reads ahead and gives back on one thread.
  mutable size_t used_ = 0;
  mutable size_t most_ = 0;
  mutable size_t all_ = 0;
};

TEST(VolumeLevels, haveNoMoreThanAPartOfALargeSliceInMemory) {
  VolumeGrid grid;
  grid.size = {2048, 8193, 2};
  const auto zeros = std::make_shared<CountedZeros>(grid.voxelCount() * sizeof(double));
  const ScalarVolume level = averagedLevel({grid, VoxelType::kFloat64, zeros}, 2);
  EXPECT_EQ(level.grid().size, glm::ivec3(1024, 4097, 1));
  EXPECT_EQ(zeros->all(), zeros->bytes().size()) << "each row once";
  EXPECT_EQ(zeros->used(), 0U);
  EXPECT_LE(zeros->most(), size_t{128} << 20U);
}

TEST(VolumeLevels, standWhereTheirVoxelsDo) {
  const ScalarVolume whole = shortVolume({24, 9, 7});
  const VolumeGrid grid = levelGrid(whole.grid(), glm::ivec3(3));
  // The centre of voxels 3, 4 and 5 is that of voxel 4.
  const auto at = [](const VolumeGrid& any, double i, double j, double k) {
    return glm::dvec3(any.worldFromIndex * glm::dvec4(i, j, k, 1));
  };
  EXPECT_LT(glm::length(at(grid, 1, 1, 1) - at(whole.grid(), 4, 4, 4)), 1e-12);
  // The lower faces, and the upper one where the factor divides the size, are those of the whole.
  EXPECT_LT(glm::length(at(grid, -0.5, -0.5, -0.5) - at(whole.grid(), -0.5, -0.5, -0.5)), 1e-12);
  EXPECT_NEAR(at(grid, 7.5, 0, 0).x, at(whole.grid(), 23.5, 0, 0).x, 1e-12);
}

TEST(VolumeLevels, areSampledInTheMiddle) {
  const ScalarVolume whole = shortVolume({23, 9, 7});
  const ScalarVolume level = sampledLevel(whole, 4);
  EXPECT_EQ(level.grid().size, glm::ivec3(6, 3, 2));
  EXPECT_EQ(level.valueAt({2, 1, 0}), whole.valueAt({9, 5, 1}));
  EXPECT_EQ(level.valueAt({5, 2, 1}), whole.valueAt({21, 8, 5}));
}

TEST(VolumeLevels, fitABudget) {
  EXPECT_EQ(levelFactor({100, 100, 100}, 1000000), 1);
  EXPECT_EQ(levelFactor({100, 100, 100}, 999999), 2);
  EXPECT_EQ(levelFactor({3200, 3200, 3200}, size_t{1} << 26U), 8);
  const auto whole = std::make_shared<const ScalarVolume>(shortVolume({20, 20, 20}));
  EXPECT_EQ(levelFor(whole, {.maxWholeBytes = 16000}).volume, whole);
  EXPECT_EQ(describeLevel(levelFor(whole, {}), whole->grid()), "");
  const VolumeLevel averaged = levelFor(whole, {.maxWholeBytes = 15999, .maxBytes = 2000});
  EXPECT_FALSE(averaged.isSampled);
  EXPECT_EQ(averaged.factor, 2);
  const VolumeLevel sampled =
      levelFor(whole, {.maxWholeBytes = 15999, .maxBytesToRead = 15999, .maxSampledBytes = 2000});
  EXPECT_TRUE(sampled.isSampled);
  EXPECT_EQ(describeLevel(sampled, whole->grid()),
            "a volume of 20 x 20 x 20 voxels is shown by 10 x 10 x 10, each one of 2 x 2 x 2 of them");
}

/// The same voxels, in memory.
ScalarVolume copied(const ScalarVolume& volume) {
  const auto bytes = std::make_shared<const std::vector<std::byte>>(volume.voxels().begin(), volume.voxels().end());
  return {volume.grid(), volume.type(), *bytes, bytes, volume.scale(), volume.offset()};
}

bool haveSameBytes(const ScalarVolume& a, const ScalarVolume& b) {
  return a.voxels().size() == b.voxels().size() &&
         std::memcmp(a.voxels().data(), b.voxels().data(), a.voxels().size()) == 0;
}

TEST(MappedVolumes, areReadWithoutTheirHolesAsVolumesInMemoryAre) {
  const test::TemporaryFolder folder;
  const test::SparseVolume file(folder.path(), {256, 200, 150}, 70, 75);
  if (!file.isSparse()) {
    GTEST_SKIP() << "this disk keeps no holes";
  }
  const ScalarVolume mapped = file.map();
  const size_t sliceBytes = 256 * 200 * 2;
  EXPECT_TRUE(mapped.store()->isKnownZero(0, 10 * sliceBytes));
  EXPECT_FALSE(mapped.store()->isKnownZero(70 * sliceBytes, 70 * sliceBytes + 1));
  EXPECT_FALSE(mapped.store()->isKnownZero(0, mapped.voxels().size()));
  // Five slices, and what their disk's blocks take in at both ends.
  EXPECT_GE(mapped.store()->bytesToRead(), 5 * sliceBytes);
  EXPECT_LE(mapped.store()->bytesToRead(), 7 * sliceBytes);

  const ScalarVolume whole = copied(mapped);
  EXPECT_TRUE(haveSameBytes(averagedLevel(mapped, 3), averagedLevel(whole, 3)));
  EXPECT_TRUE(haveSameBytes(sampledLevel(mapped, 4), sampledLevel(whole, 4)));
  // Holes are zeros, which this range takes for its lower end.
  const ValueRange range{100, 900};
  EXPECT_TRUE(haveSameBytes(averagedInRange(mapped, {3, 2, 4}, range), averagedInRange(whole, {3, 2, 4}, range)));
  const VoxelSurvey survey = surveyVoxels(mapped);
  EXPECT_EQ(survey.range.least, 0);
  EXPECT_EQ(survey.range.greatest, test::SparseVolume::kSlabValue);
  const VolumeHistogram histogram = histogramOf(mapped);
  EXPECT_EQ(histogram.counts, histogramOf(whole).counts);
  EXPECT_EQ(histogram.counts.back(), 5U * 256 * 200);
  const VolumeBricks bricks(mapped);
  const VolumeBricks expected(whole);
  ASSERT_EQ(bricks.size(), expected.size());
  for (size_t brick = 0; brick < bricks.ranges().size(); ++brick) {
    EXPECT_EQ(bricks.ranges()[brick].least, expected.ranges()[brick].least);
    EXPECT_EQ(bricks.ranges()[brick].greatest, expected.ranges()[brick].greatest);
  }
}

TEST(MappedVolumes, mayBeginAnywhereAtAMultipleOfAVoxel) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "numbers.raw";
  std::vector<uint16_t> numbers(1000);
  std::iota(numbers.begin(), numbers.end(), uint16_t{0});
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(numbers.data()), 2000);
  VolumeGrid grid;
  grid.size = {10, 10, 5};
  const ScalarVolume volume = mapVolumes(grid, VoxelType::kUint16, path, {2 * 123}).front();
  EXPECT_EQ(volume.valueAt({0, 0, 0}), 123);
  EXPECT_EQ(volume.valueAt({9, 9, 4}), 622);
  EXPECT_TRUE(areVoxelsAligned(4, VoxelType::kFloat32));
  EXPECT_FALSE(areVoxelsAligned(4, VoxelType::kFloat64));
  try {
    mapVolumes(grid, VoxelType::kUint16, path, {1002});
    FAIL() << "the file is too short";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("numbers.raw"), testing::HasSubstr("2000")));
  }
}

TEST(MappedVolumes, shareOneMappingOfTheirFile) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "moments.raw";
  std::ofstream(path, std::ios::binary) << std::string(300, '\1') << std::string(100, '\2');
  VolumeGrid grid;
  grid.size = {10, 10, 1};
  const std::vector<ScalarVolume> volumes = mapVolumes(grid, VoxelType::kUint8, path, {0, 100, 300}, 2);
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_EQ(volumes[1].valueAt({9, 9, 0}), 2);
  EXPECT_EQ(volumes[2].valueAt({0, 0, 0}), 4);
  size_t mappings = 0;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    mappings += line.ends_with("/moments.raw") ? 1 : 0;
  }
  EXPECT_EQ(mappings, 1U);
  EXPECT_THROW(mapVolumes(grid, VoxelType::kUint8, path, {0, 301}), InputError);
}

}  // namespace
}  // namespace ocelli
