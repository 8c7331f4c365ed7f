#include "display_sim/observing/observe_series.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// Keeps what it is given.
struct KeptFrames : FrameSink {
  void add(const Image<Rgb8>& frame) override { frames.push_back(frame); }
  void finish() override {}
  std::vector<Image<Rgb8>> frames;
};

/// A voxel of each of three slices.
Volume fewVoxels() {
  Volume volume(test::smallProfile(20, 32, 32));
  volume.light(3, 25, 10, 7);
  volume.light(9, 20, 16, 1);
  volume.light(15, 4, 22, 6);
  return volume;
}

constexpr ObserverOptions kSmall{.width = 60, .height = 40};

// A voxel at r radii to the front, seen by eyes +-s/2 at the distance d: its images are apart by the difference of
// angles, f s r / (d (d - r)), in the first order of s / d: 0.3 % here.
TEST(ObserveSeries, aPairHasParallax) {
  Volume volume(test::smallProfile(20, 33, 33));
  volume.light(10, 29, 16, 7);  // on the z axis
  const double r = 13 / 16.5;
  const ObserverOptions options{.width = 400, .height = 400};
  const LightPair pair = collectPair([&](const ObserverOptions& o) { return collectLight(volume, o); }, options, 1);
  const double f = 200 / std::tan(std::asin(0.1));
  const double apart = test::spreadOf(pair.left).center.x - test::spreadOf(pair.right).center.x;
  EXPECT_NEAR(apart / (f * r / (10 * (10 - r))), 1, 0.005);
  const Image<glm::vec3> both = sideBySide(pair);
  EXPECT_EQ(both.width(), 800);
  EXPECT_EQ(both(210, 200), pair.left(210, 200));
  EXPECT_EQ(both(590, 200), pair.right(190, 200));
}

TEST(ObserveSeries, framesAreObservedWithOneGain) {
  const Volume volume = fewVoxels();
  const CollectLight collect = [&](const ObserverOptions& o) { return collectLight(volume, o); };
  const ObserverSeries series{.eyes = turntableEyes({0, 1, 9}, 12)};
  const double gain = seriesGain(collect, kSmall, series);
  for (const size_t frame : {0u, 4u, 8u}) {
    ObserverOptions there = kSmall;
    there.eye = series.eyes[frame];
    EXPECT_LE(gain, automaticGain(collect(there)));
  }
  KeptFrames kept;
  observeSeries(collect, kSmall, series, gain, kept);
  ASSERT_EQ(kept.frames.size(), 12u);
  for (size_t frame = 0; frame < 12; ++frame) {
    ObserverOptions there = kSmall;
    there.eye = series.eyes[frame];
    there.tone.gain = gain;
    EXPECT_EQ(kept.frames[frame], srgbFromLinear(observe(volume, there)));
  }
  ObserverOptions fixed = kSmall;
  fixed.tone.gain = 3;
  EXPECT_EQ(seriesGain(collect, fixed, series), 3);
}

TEST(ObserveSeries, darkFramesDoNotCountForTheGain) {
  const ObserverSeries series{.eyes = turntableEyes({0, 1, 9}, 5)};
  const CollectLight collect = [&](const ObserverOptions& o) {
    return Image<glm::vec3>(2, 2, glm::vec3(o.eye == series.eyes[2] ? 0.01f : 0.0f));
  };
  EXPECT_NEAR(seriesGain(collect, kSmall, series), 95, 1e-4);  // floats are exact to 6e-8
}

TEST(ObserveSeries, wayIntoTheDisplayNamesThePose) {
  const DisplayProfile profile = test::smallProfile(20, 32, 32);
  const auto problem = [&](const std::vector<EyePose>& poses) -> std::string {
    try {
      checkWay(poses, 4, profile, "way.csv");
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(problem({{0, {0, 0, 10}}, {1, {3, 0, 9}}}), "");
  EXPECT_THAT(problem({{5, {0, 0, 10}}, {6, {0, 0, 2}}, {7, {0, 0, -2}}}), HasSubstr("way.csv, between poses 2 and 3"));
  EXPECT_THAT(problem({{5, {0, 0, 10}}, {6, {0, 0, 0.5f}}}), HasSubstr("way.csv, at pose 2"));
  EXPECT_THAT(problem({{5, {0, 0, 0.5f}}}), HasSubstr("way.csv, at pose 1"));
}

TEST(ObserveSeries, pairsStandSideBySideInFrames) {
  const Volume volume = fewVoxels();
  KeptFrames kept;
  observeSeries([&](const ObserverOptions& o) { return collectLight(volume, o); }, kSmall,
                {.eyes = {{0, 0, 10}, {0, 5, 10}}, .separationRadii = 0.5}, 1, kept);
  ASSERT_EQ(kept.frames.size(), 2u);
  EXPECT_EQ(kept.frames[1].width(), 120);
}

TEST(ObserveSeries, everyEyeIsChecked) {
  const DisplayProfile profile = test::smallProfile(20, 32, 32);
  EXPECT_NO_THROW(checkSeries({.eyes = {{0, 0, 10}, {0, 0, 5}}}, kSmall, profile));
  EXPECT_THROW(checkSeries({.eyes = {{0, 0, 10}, {0, 0, 0.5f}}}, kSmall, profile), InputError);
}

}  // namespace
}  // namespace ocelli
