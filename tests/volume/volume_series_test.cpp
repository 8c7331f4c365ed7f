#include "oc_core/volume/volume_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <span>

#include "oc_core/base/error.h"
#include "oc_core/volume/transfer_presets.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

ScalarVolume lineOf(std::vector<float> values) {
  VolumeGrid grid;
  grid.size = {static_cast<int>(values.size()), 1, 1};
  return {grid, std::move(values)};
}

VolumeSeries threeMoments() {
  VolumeSeries series{.source = "beating.nrrd", .volumes = {}, .times = {1, 2, 4}};
  for (const float greatest : {1.0f, 2.0f, 4.0f}) {
    series.volumes.push_back(std::make_shared<const ScalarVolume>(lineOf({0, greatest, 0})));
  }
  return series;
}

template <class Call>
std::string errorOfCall(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(VolumeSeries, showsTheLastVolumeThatBeginsByThen) {
  const VolumeSeries series = threeMoments();
  EXPECT_EQ(series.indexAt(1), 0U);
  EXPECT_EQ(series.indexAt(1.99), 0U);
  EXPECT_EQ(series.indexAt(2), 1U);
  EXPECT_EQ(series.indexAt(4), 2U);
  EXPECT_THAT(errorOfCall([&] { series.indexAt(4.1); }), HasSubstr("from 1 to 4"));
  EXPECT_THAT(errorOfCall([&] { series.indexAt(std::numeric_limits<double>::quiet_NaN()); }), HasSubstr("no time"));
  EXPECT_THAT(errorOfCall([&] { loadVolumeScene("builtin:volume,name=ramp,size=8", {.seconds = 1}); }),
              HasSubstr("stands still"));
}

TEST(VolumeSeries, looksTheSameAtAllTimes) {
  const VolumeSeries series = threeMoments();
  for (size_t index = 0; index < 3; ++index) {
    const VolumeScene scene = volumeSceneAt(series, index);
    EXPECT_EQ(scene.times, series.times);
    // The grey ramp reaches from the least to the greatest value, of the first volume.
    EXPECT_EQ(scene.appearance.transfer.points().back().value, 1);
    EXPECT_EQ(scene.volume->valueAt({1, 0, 0}), index == 0 ? 1 : 2 * index);
  }
}

TEST(VolumeSeries, looksAsADescriptionWithoutAFileSays) {
  const VolumeSeries series = threeMoments();
  TransferDescription relative{.scale = "range",
                               .points = {transferPoint(0, 0x000000, 0), transferPoint(1, 0xff0000, 1)}};
  for (size_t index = 0; index < 3; ++index) {
    const VolumeScene scene = volumeSceneAt(series, index, relative, {.transfer = "ct-bone"});
    // In the values of the first volume.
    EXPECT_EQ(scene.appearance.transfer.points().back().value, 1);
    EXPECT_EQ(scene.appearance.transfer.points().back().color, glm::dvec3(1, 0, 0));
  }
}

TEST(VolumeSeries, hasWarningsOnlyForThoseWhoAsk) {
  VolumeSeries series = threeMoments();
  series.warnings = {"something is odd"};
  std::vector<std::string> told;
  volumeSceneAt(series, 0, {.warn = [&](const std::string& sentence) { told.push_back(sentence); }});
  EXPECT_EQ(told, series.warnings);
  volumeSceneAt(series, 0);
}

TEST(VolumeScene, refusesValuesBeyondWhatCanBeShown) {
  const auto errorOf = [](VoxelType type, const auto& values, double scale) {
    VolumeGrid grid;
    grid.size = {2, 1, 1};
    VolumeSeries series{.source = "huge.nrrd", .volumes = {}};
    series.volumes.push_back(
        std::make_shared<const ScalarVolume>(grid, type, std::as_bytes(std::span(values)), nullptr, scale));
    return errorOfCall([&] { volumeSceneAt(series, 0); });
  };
  using Doubles = std::array<double, 2>;
  using Shorts = std::array<int16_t, 2>;
  EXPECT_THAT(errorOf(VoxelType::kFloat64, Doubles{0, 1e300}, 1),
              testing::AllOf(HasSubstr("1e+300"), HasSubstr("huge")));
  EXPECT_THAT(errorOf(VoxelType::kInt16, Shorts{0, 30}, 1e308), HasSubstr("from 0 to inf"));
  EXPECT_THAT(errorOf(VoxelType::kFloat64, Doubles{0, -2e37}, 1), HasSubstr("-2e+37"));
  EXPECT_EQ(errorOf(VoxelType::kFloat64, Doubles{0, 1e300}, 1e-290), "");
  // What voxels hold counts, not what they could.
  EXPECT_EQ(errorOf(VoxelType::kInt16, Shorts{0, 30}, 1e35), "");
}

TEST(VolumeScene, saysWhyNothingIsShownOfAVolumeOfOneValue) {
  VolumeSeries series{.source = "flat.nrrd", .volumes = {}};
  series.volumes.push_back(std::make_shared<const ScalarVolume>(lineOf({0.5f, 0.5f, 0.5f})));
  std::vector<std::string> told;
  volumeSceneAt(series, 0, {.warn = [&](const std::string& sentence) { told.push_back(sentence); }});
  EXPECT_THAT(told, testing::ElementsAre(HasSubstr("all voxels have the value 0.5")));
}

TEST(VolumeScene, refusesVoxelsThatAreNoNumbers) {
  VolumeSeries series{.source = "odd.nrrd", .volumes = {}};
  series.volumes.push_back(
      std::make_shared<const ScalarVolume>(lineOf({0, 1, std::numeric_limits<float>::quiet_NaN()})));
  EXPECT_THAT(errorOfCall([&] { volumeSceneAt(series, 0); }),
              testing::AllOf(HasSubstr("odd.nrrd"), HasSubstr("1 voxel is"), HasSubstr("(2, 0, 0)")));
  // A level of it says no more than where to look.
  EXPECT_THAT(errorOfCall([&] { volumeSceneAt(series, 0, {.level = {.maxWholeBytes = 8, .maxBytes = 8}}); }),
              testing::AllOf(HasSubstr("at least 1"), HasSubstr("from index (2, 0, 0) up to 1 further")));
}

TEST(VolumeScene, isFittedWhereverItsFileHasIt) {
  const auto sceneOf = [](const glm::dvec3& origin) {
    VolumeGrid grid;
    grid.size = {16, 8, 4};
    grid.worldFromIndex = {{0, 0.001, 0, 0}, {-0.001, 0, 0, 0}, {0, 0, 0.002, 0}, glm::dvec4(origin, 1)};
    VolumeSeries series{.source = "far.nrrd", .volumes = {}};
    series.volumes.push_back(std::make_shared<const ScalarVolume>(grid, std::vector<float>(grid.voxelCount(), 1)));
    series.appearance = VolumeAppearance{TransferFunction({{0, {}, 0}, {1, {}, 1}}, 1)};
    return volumeSceneAt(series, 0);
  };
  const VolumeScene near = sceneOf(glm::dvec3(0));
  const VolumeScene far = sceneOf({50000, -70000, 90000});
  const glm::dvec3 size(far.bounds().size());
  EXPECT_NEAR(glm::length(size), 2, 1e-6);
  EXPECT_NEAR(size.y, 2 * size.x, 1e-6);
  EXPECT_NEAR(glm::length(far.bounds().center()), 0, 1e-6);
  for (int column = 0; column < 4; ++column) {
    // A double at 90000 is good to 1.5e-11, a radius of 0.01 makes this 1.5e-9, and some of these come together.
    EXPECT_NEAR(glm::length(far.worldFromIndex[column] - near.worldFromIndex[column]), 0, 1e-8) << column;
  }
}

TEST(VolumeScene, isShownByALevelInTheSamePlaceAndOfTheSameOpacity) {
  const std::string source = "builtin:volume,name=skull,size=32";
  std::vector<std::string> told;
  const VolumeSceneOptions coarse{.transfer = "ct-bone",
                                  .level = {.maxWholeBytes = 1000, .maxBytes = 8192},
                                  .warn = [&](const std::string& sentence) { told.push_back(sentence); }};
  const VolumeScene whole = loadVolumeScene(source, {.transfer = "ct-bone"});
  const VolumeScene level = loadVolumeScene(source, coarse);
  EXPECT_EQ(whole.levelFactor, 1);
  EXPECT_EQ(whole.whole, whole.volume);
  EXPECT_EQ(level.levelFactor, 2);
  EXPECT_EQ(level.whole->grid().size, glm::ivec3(32));
  EXPECT_EQ(level.volume->grid().size, glm::ivec3(16));
  EXPECT_THAT(told, testing::ElementsAre(HasSubstr("the mean of 2 x 2 x 2")));
  EXPECT_EQ(level.appearance.transfer.opacityLength(), whole.appearance.transfer.opacityLength());
  EXPECT_NEAR(level.sceneLengthOfUnit(), whole.sceneLengthOfUnit(), 1e-12);
  // Boxes are of floats.
  EXPECT_NEAR(glm::length(level.bounds().lower - whole.bounds().lower), 0, 1e-6);
  EXPECT_NEAR(glm::length(level.bounds().upper - whole.bounds().upper), 0, 1e-6);
}

}  // namespace
}  // namespace ocelli
