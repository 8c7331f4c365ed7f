#include "display_sim/volume_slicing/swept_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "display_sim/volume_slicing/swept_samples.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

TEST(SweptRange, CommonValuesLeaveOutTheRareButNotTheBackground) {
  VolumeGrid grid;
  grid.size = {16, 16, 16};
  std::vector<float> values(grid.voxelCount(), 0.0f);
  for (size_t i = 0; i < 1000; ++i) {
    values[i] = 100 + static_cast<float>(i);
  }
  values.back() = 1e6f;
  const ValueRange common = commonValues(ScalarVolume(grid, values));
  EXPECT_EQ(common.least, 0);
  // Half of a hundredth of the 1000 is rare; the rank is a whole number.
  EXPECT_NEAR(common.greatest, 100 + 995, 1);
}

TEST(SweptRange, OfTwoValuesAreBoth) {
  VolumeGrid grid;
  grid.size = {16, 16, 16};
  std::vector<float> values(grid.voxelCount(), -7.0f);
  std::fill(values.begin(), values.begin() + 1000, 5.0f);
  const ValueRange common = commonValues(ScalarVolume(grid, values));
  EXPECT_EQ(common.least, -7);
  EXPECT_EQ(common.greatest, 5);
}

TEST(SweptRange, OfAnEvenVolumeIsItsValue) {
  VolumeGrid grid;
  grid.size = {4, 4, 4};
  const ValueRange common = commonValues(ScalarVolume(grid, std::vector<float>(64, 3.0f)));
  EXPECT_EQ(common.least, 3);
  EXPECT_EQ(common.greatest, 3);
}

TEST(SweptRange, TransferFunctionsChangeWhereTheyLookDifferent) {
  const glm::dvec3 white(1);
  EXPECT_EQ(valuesOfChange(TransferFunction({{0, white, 0.5}, {9, white, 0.5}}, 1)), std::vector<double>{});
  // Where there is no opacity no colour is seen.
  EXPECT_EQ(valuesOfChange(TransferFunction(
                {{-1000, {1, 0, 0}, 0}, {300, white, 0}, {400, white, 1}, {500, white, 0.5}, {3000, white, 0.5}}, 1)),
            (std::vector<double>{300, 500}));
}

TEST(SweptRange, HoldsWhatIsWantedWithAMarginWithinAllValues) {
  const ValueRange all{-1000, 1e6};
  const ValueRange common{0, 100};
  EXPECT_EQ(codedRange(all, common, {}).least, -50);
  EXPECT_EQ(codedRange(all, common, {}).greatest, 150);
  // With a margin of some hundredths of the range, which is 450 wide.
  EXPECT_GT(codedRange(all, common, {400}).greatest, 400);
  EXPECT_LT(codedRange(all, common, {400}).greatest, 450);
  EXPECT_EQ(codedRange(all, common, {-1e9, 1e9}).least, -1000);
  EXPECT_EQ(codedRange(all, common, {-1e9, 1e9}).greatest, 1e6);
  EXPECT_EQ(codedRange(common, common, {}).greatest, 100);
}

TEST(SweptRange, LightOfANarrowBandIsTheSameBesideOneExtremeVoxel) {
  const DisplayProfile profile = test::sweptProfile(24, 64, 64);
  const auto lightWith = [&](double extreme) {
    const VolumeScene scene = test::sceneOfField(
        32, 0.6,
        [&](const glm::dvec3& p) {
          return glm::length(p - glm::dvec3(0.58)) < 0.02 ? extreme : 1000 * std::max(1 - glm::length(p) / 0.5, 0.0);
        },
        TransferFunction({{300, {1, 1, 1}, 0}, {310, {1, 1, 1}, 0.5}, {320, {1, 1, 1}, 0}}, 0.1));
    const SweptSamples samples(scene, profile);
    EXPECT_GT(samples.commonSteps(), 400);
    const SweptLight light(scene.appearance.transfer, samples.range(), 1, samples.sweep());
    double sum = 0;
    for (int column = 32; column < 64; ++column) {
      for (int row = 0; row < 64; ++row) {
        sum += double{light.lightOf(samples.codeAt(5, column, row), column).x};
      }
    }
    return sum;
  };
  const double light = lightWith(0);
  EXPECT_GT(light, 1);
  // The band is 15 steps wide instead of 20, as the range is wider than what is common.
  EXPECT_NEAR(lightWith(30000), light, 0.05 * light);
  EXPECT_NEAR(lightWith(1e6), light, 0.05 * light);
}

}  // namespace
}  // namespace ocelli
