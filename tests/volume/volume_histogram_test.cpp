#include "oc_core/volume/volume_histogram.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_gradient.h"
#include "oc_core/volume/voxel_survey.h"
#include "tests/volume/field_volume.h"

namespace ocelli {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Of a sheared grid that mirrors: the gradient of any linear field is known.
VolumeGrid shearedGrid(const glm::ivec3& size) {
  VolumeGrid grid;
  grid.size = size;
  grid.worldFromIndex = {{-2, 0, 0, 0}, {0.5, 3, 0, 0}, {0.25, -0.5, 1, 0}, {10, 20, 30, 1}};
  return grid;
}

ScalarVolume linearIn(const VolumeGrid& grid, const glm::dvec3& slope) {
  return {grid, test::voxelsInWorld(grid, [&](const glm::dvec3& p) { return glm::dot(slope, p); })};
}

TEST(VolumeHistogram, CountsWholeNumbersOneByOne) {
  const ScalarVolume volume =
      test::volumeOfVoxels<int16_t>({.size = {5, 2, 1}}, VoxelType::kInt16, {-3, -3, 0, 0, 0, 0, 0, 2, 2, 7}, 2, 1);
  const VolumeHistogram histogram = histogramOf(volume);
  EXPECT_EQ(histogram.counts, (std::vector<uint64_t>{2, 0, 0, 5, 0, 2, 0, 0, 0, 0, 1}));
  EXPECT_EQ(histogram.total(), 10U);
  EXPECT_EQ(histogram.values.least, -5);
  EXPECT_EQ(histogram.values.greatest, 15);
  EXPECT_EQ(histogram.bounds.least, -6);
  EXPECT_EQ(histogram.bounds.greatest, 16);
  EXPECT_EQ(histogram.binWidth(), 2);
}

TEST(VolumeHistogram, IsThatOfWhatVoxelsMeanWhereTheScaleIsNegative) {
  const ScalarVolume volume =
      test::volumeOfVoxels<uint8_t>({.size = {4, 1, 1}}, VoxelType::kUint8, {1, 1, 1, 3}, -1, 0);
  const VolumeHistogram histogram = histogramOf(volume);
  EXPECT_EQ(histogram.bounds.least, -3.5);
  EXPECT_EQ(histogram.counts, (std::vector<uint64_t>{1, 0, 3}));
}

TEST(VolumeHistogram, LeavesOutWhatIsNoNumberAndTakesAFlatVolume) {
  VolumeGrid grid;
  grid.size = {4, 1, 1};
  const VolumeHistogram histogram = histogramOf({grid, {0, kNan, 1, 1}});
  EXPECT_EQ(histogram.total(), 3U);
  EXPECT_EQ(histogram.counts.front(), 1U);
  EXPECT_EQ(histogram.counts.back(), 2U);
  const VolumeHistogram flat = histogramOf({grid, {5, 5, 5, 5}});
  EXPECT_EQ(flat.counts, (std::vector<uint64_t>{4}));
}

TEST(VoxelSurvey, SaysHowManyVoxelsAreNoNumbersAndWhere) {
  VolumeGrid grid;
  grid.size = {20, 3, 2};
  std::vector<float> values(grid.voxelCount(), 1);
  values[0] = -2;
  values[(1 * 3 + 2) * 20 + 17] = kNan;
  values[(1 * 3 + 2) * 20 + 19] = std::numeric_limits<float>::infinity();
  const VoxelSurvey survey = surveyVoxels({grid, values});
  EXPECT_EQ(survey.range.least, -2);
  EXPECT_EQ(survey.range.greatest, 1);
  EXPECT_EQ(survey.notFinite, 2U);
  EXPECT_EQ(survey.firstNotFinite, glm::ivec3(17, 2, 1));
  try {
    requireFinite(survey, "some.nrrd");
    FAIL() << "two voxels are no numbers";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("some.nrrd"));
    EXPECT_THAT(error.what(), testing::HasSubstr("2 voxels"));
    EXPECT_THAT(error.what(), testing::HasSubstr("(17, 2, 1)"));
  }
  requireFinite(surveyVoxels({grid, std::vector<float>(grid.voxelCount())}), "some.nrrd");
}

TEST(VoxelSurvey, TakesNoBoundsFromVoxelsThatAreNoNumbers) {
  VolumeGrid grid;
  grid.size = {3, 1, 2};
  const VoxelSurvey none = surveyVoxels({grid, std::vector<float>(grid.voxelCount(), kNan)});
  EXPECT_EQ(none.notFinite, 6U);
  EXPECT_EQ(none.range.least, 0);
  EXPECT_EQ(none.range.greatest, 0);
  // Whole slices without numbers may be surveyed by themselves.
  grid.size = {1, 1, 64};
  std::vector<float> values(grid.voxelCount(), kNan);
  values.front() = 2;
  values[1] = 5;
  const VoxelSurvey some = surveyVoxels({grid, values});
  EXPECT_EQ(some.range.least, 2);
  EXPECT_EQ(some.range.greatest, 5);
}

TEST(VolumeGradient, IsThatOfTheWorld) {
  const glm::dvec3 slope(1, -2, 0.5);
  const ScalarVolume volume = linearIn(shearedGrid({5, 4, 3}), slope);
  for (const glm::dvec3& index :
       {glm::dvec3(2, 2, 1), glm::dvec3(0, 0, 0), glm::dvec3(3.7, 2.2, 1.9), glm::dvec3(-0.5, 3.5, 2.5)}) {
    const glm::dvec3 gradient = gradientAt(volume, index);
    // Values are floats of up to 100.
    EXPECT_NEAR(glm::length(gradient - slope), 0, 1e-4) << index.x << " " << index.y << " " << index.z;
  }
  EXPECT_EQ(gradientAt(linearIn(shearedGrid({5, 1, 1}), {1, 0, 0}), {2, 0, 0}).z,
            worldGradientFromIndex(shearedGrid({5, 1, 1}).worldFromIndex)[0].z * -2);
}

}  // namespace
}  // namespace ocelli
