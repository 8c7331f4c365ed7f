#include "display_sim/observing/wobble.h"

#include <gtest/gtest.h>

#include <limits>

#include "display_sim/observing/observer.h"
#include "oc_core/base/error.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;

constexpr int kWobbleSide = 200;
const double kPixelsPerRadius = kWobbleSide / 2.0 / (10 * std::tan(std::asin(0.1)));  // at the distance of the axis
constexpr double kAmplitude = 0.1;

/// A voxel of slice 0, seen straight on.
Volume oneVoxel(const DisplayProfile& profile) {
  Volume volume(profile);
  volume.light(0, 16, 16, kAllChannels);
  return volume;
}

test::Spread seen(const Wobble& wobble, double refreshes) {
  const ObserverOptions options{.width = kWobbleSide,
                                .height = kWobbleSide,
                                .exposureSeconds = refreshes / 24,
                                .startDegrees = -2.25,
                                .wobble = wobble};
  return test::spreadOf(collectLight(oneVoxel(smallProfile(40, 32, 32)), options));
}

// The arc of slice 0 is 4.5 degrees: cos() stays within 8e-4 of its value in the middle. 0.01 pixels are that, of 10.
constexpr double kSlack = 0.01;

TEST(Wobble, movesTheAxis) {
  const test::Spread still = seen({}, 1);
  for (const double phase : {0.0, 60.0, 180.0, -45.0}) {
    const double swing = kAmplitude * std::cos(radiansFromDegrees(phase)) * kPixelsPerRadius;
    const test::Spread up = seen({.amplitudeRadii = kAmplitude, .direction = {0, 3, 0}, .phaseDegrees = phase}, 1);
    EXPECT_NEAR(up.center.x, still.center.x, kSlack) << phase;
    EXPECT_NEAR(up.center.y, still.center.y - swing, kSlack) << phase;
    const test::Spread right = seen({.amplitudeRadii = kAmplitude, .phaseDegrees = phase}, 1);
    EXPECT_NEAR(right.center.x, still.center.x + swing, kSlack) << phase;
  }
}

// Once a turn: half a turn later the axis stands on the other side, and the variance of two images is the square of
// their distance from the middle.
TEST(Wobble, ofOneSwingATurnShowsRevisitedVoxelsTwice) {
  const test::Spread still = seen({}, 1);
  const Wobble once{.amplitudeRadii = kAmplitude};
  const double square = std::pow(kAmplitude * kPixelsPerRadius, 2);
  for (const int refreshes : {2, 4, 10}) {
    const test::Spread twice = seen(once, refreshes);
    EXPECT_NEAR(twice.center.x, still.center.x, kSlack);
    EXPECT_NEAR(twice.variance.x - still.variance.x, square, 1e-2 * square);
    EXPECT_NEAR(twice.variance.y, still.variance.y, kSlack);
  }
  // Of three passes two are on the one side, one on the other: the variance is 8 / 9.
  EXPECT_NEAR(seen(once, 3).variance.x - still.variance.x, square * 8 / 9, 1e-2 * square);
}

TEST(Wobble, ofTwoSwingsATurnBlursNothing) {
  const test::Spread once = seen({.amplitudeRadii = kAmplitude, .frequency = 2}, 1);
  const test::Spread often = seen({.amplitudeRadii = kAmplitude, .frequency = 2}, 7);
  EXPECT_NEAR(often.center.x, once.center.x, 1e-4);  // shares of light are rounded to 2^-24
  EXPECT_NEAR(often.variance.x, once.variance.x, 1e-4);
}

// A swing that fits into no number of turns is seen at all of its phases alike: its variance is a half. 1000 passes
// leave the ends of the golden sequence uneven by less than a hundredth.
TEST(Wobble, withoutACommonPeriodBlursBySinesVariance) {
  const test::Spread still = seen({}, 1);
  const double square = std::pow(kAmplitude * kPixelsPerRadius, 2);
  const Wobble wobble{.amplitudeRadii = kAmplitude, .frequency = (1 + std::sqrt(5)) / 2};
  EXPECT_NEAR(seen(wobble, 1000).variance.x - still.variance.x, square / 2, 0.02 * square);
}

TEST(Wobble, passesAreSortedByPhase) {
  const DisplayProfile profile = smallProfile(10, 16, 16);
  const Sweep sweep{0, 10 * kPi};
  const auto arcsOfSlice3 = [&](const Wobble& wobble) {
    std::vector<ExposedArc> arcs = exposedArcs(profile, sweep, wobble);
    std::erase_if(arcs, [](const ExposedArc& arc) { return arc.slice != 3; });
    return arcs;
  };
  EXPECT_EQ(arcsOfSlice3({}).size(), 1u);
  EXPECT_EQ(arcsOfSlice3({.amplitudeRadii = 0.1, .frequency = 1}).size(), 2u);
  EXPECT_EQ(arcsOfSlice3({.amplitudeRadii = 0.1, .frequency = 0.4}).size(), 5u);
  const std::vector<ExposedArc> arcs = arcsOfSlice3({.amplitudeRadii = 0.1, .frequency = 1});
  EXPECT_EQ(arcs[0].passes, 5);
  EXPECT_EQ(arcs[1].passes, 5);
  EXPECT_NEAR(std::abs(arcs[0].swingRadians - arcs[1].swingRadians), kPi, 1e-12);
  EXPECT_EQ(arcs[0].turnedPasses + arcs[1].turnedPasses, 5);
  const std::vector<ExposedArc> many =
      exposedArcs(profile, {0, 1000 * kPi}, {.amplitudeRadii = 0.1, .frequency = 1.234567});
  EXPECT_LE(many.size(), size_t{11} * kMaxWobblePhases);
  double passes = 0;
  for (const ExposedArc& arc : many) {
    passes += arc.slice == 3 ? arc.passes : 0;
  }
  EXPECT_EQ(passes, 1000);
}

TEST(Wobble, badValuesAreInputErrors) {
  const Volume volume(smallProfile(4, 8, 8));
  const auto look = [&](const Wobble& wobble, double seconds = 0) {
    collectLight(volume, {.width = 4, .height = 4, .exposureSeconds = seconds, .wobble = wobble});
  };
  EXPECT_THROW(look({.amplitudeRadii = -1}), InputError);
  EXPECT_THROW(look({.amplitudeRadii = 2}), InputError);
  EXPECT_THROW(look({.direction = {0, 0, 0}}), InputError);
  EXPECT_THROW(look({.direction = {0, std::numeric_limits<float>::quiet_NaN(), 0}}), InputError);
  EXPECT_THROW(look({.frequency = -1}), InputError);
  EXPECT_THROW(look({.frequency = 1000}), InputError);
  EXPECT_THROW(look({.phaseDegrees = 400}), InputError);
  DisplayProfile fast = smallProfile(4, 8, 8);
  fast.rotationsPerMinute = 1e6;
  EXPECT_THROW(collectLight(Volume(fast), {.exposureSeconds = 3600, .wobble = {.amplitudeRadii = 0.1}}), InputError);
  EXPECT_NO_THROW(collectLight(Volume(fast), {.width = 4, .height = 4, .exposureSeconds = 3600}));
}

}  // namespace
}  // namespace ocelli
