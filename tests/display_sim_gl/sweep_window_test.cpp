#include "display_sim/gl/sweep_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;

constexpr double kStep = kPi / 10;

TEST(SweepWindow, aStepShowsOneSlice) {
  const auto arcs = windowArcs(smallProfile(10, 8, 8), {.endRadians = 3.5 * kStep, .sweptRadians = kStep});
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].slice, 3);
  EXPECT_NEAR(arcs[0].fromRadians, 2.5 * kStep, 1e-12);
  EXPECT_NEAR(arcs[0].toRadians, 3.5 * kStep, 1e-12);
  EXPECT_EQ(arcs[0].passes, 1);
}

TEST(SweepWindow, itsEndsCutArcs) {
  const auto arcs = windowArcs(smallProfile(10, 8, 8), {.endRadians = 0.25 * kStep, .sweptRadians = kStep});
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].slice, 0);
  EXPECT_NEAR(arcs[0].fromRadians, -0.5 * kStep, 1e-12);
  EXPECT_NEAR(arcs[0].toRadians, 0.25 * kStep, 1e-12);
  EXPECT_EQ(arcs[1].slice, 9) << "the half turn before";
  EXPECT_NEAR(arcs[1].fromRadians, 9.25 * kStep, 1e-12);
  EXPECT_NEAR(arcs[1].toRadians, 9.5 * kStep, 1e-12);
}

TEST(SweepWindow, aWholeRefreshIsAnExposureOfOne) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const DisplayProfile profile = smallProfile(10, 8, 8, half);
    const double period = kStep * profile.storedSlices();
    // It ends between two slices, so that no arc is cut, after and before many turns.
    for (const int turns : {0, 7, -7}) {
      const auto arcs = windowArcs(profile, {.endRadians = -kStep / 2 + turns * 2 * kPi, .sweptRadians = period});
      const auto exposed =
          exposedArcs(profile, sweepEndingAt(profile, 1 / profile.refreshHertz(), degreesFromRadians(-kStep / 2)));
      ASSERT_EQ(arcs.size(), exposed.size());
      for (size_t i = 0; i < arcs.size(); ++i) {
        EXPECT_EQ(arcs[i].slice, exposed[i].slice);
        EXPECT_NEAR(arcs[i].fromRadians, exposed[i].fromRadians, 1e-9);
        EXPECT_NEAR(arcs[i].toRadians, exposed[i].toRadians, 1e-9);
        EXPECT_EQ(arcs[i].passes, 1);
        EXPECT_EQ(arcs[i].turnedPasses, exposed[i].turnedPasses);
      }
    }
  }
}

TEST(SweepWindow, turnsAddUp) {
  const auto arcs = windowArcs(smallProfile(10, 8, 8), {.endRadians = kStep / 2, .sweptRadians = 3 * 2 * kPi});
  ASSERT_EQ(arcs.size(), 10u);
  for (const ExposedArc& arc : arcs) {
    EXPECT_EQ(arc.passes, 6) << "two half turns a turn";
  }
}

TEST(SweepWindow, everySecondPassIsTurned) {
  const auto arcs = windowArcs(smallProfile(10, 8, 8), {.endRadians = kStep / 2, .sweptRadians = 3 * kPi});
  ASSERT_EQ(arcs.size(), 10u);
  for (const ExposedArc& arc : arcs) {
    EXPECT_EQ(arc.passes, 3);
    EXPECT_EQ(arc.turnedPasses, arc.slice == 0 ? 1 : 2) << "they end unturned with slice 0";
  }
}

TEST(SweepWindow, knowsWobbleAndChannelsAsExposuresDo) {
  DisplayProfile profile = smallProfile(10, 8, 8);
  profile.channelTiming = ChannelTiming::kInTurn;
  const Wobble wobble{.amplitudeRadii = 0.1, .frequency = 1.5, .phaseDegrees = 20};
  const Sweep sweep{-kStep / 2 + 2 * kPi, -kStep / 2 + 5 * kPi};
  auto arcs = windowArcs(profile, {.endRadians = sweep.toRadians, .sweptRadians = sweep.radians()}, wobble);
  auto exposed = exposedArcs(profile, sweep, wobble);
  ASSERT_EQ(arcs.size(), 10u * 3 * 3);
  ASSERT_EQ(arcs.size(), exposed.size());
  for (const ExposedArc& arc : arcs) {
    const auto same = std::ranges::count_if(exposed, [&](const ExposedArc& other) {
      return arc.slice == other.slice && arc.channels == other.channels && arc.passes == other.passes &&
             arc.turnedPasses == other.turnedPasses && std::abs(arc.fromRadians - other.fromRadians) < 1e-9 &&
             std::abs(arc.toRadians - other.toRadians) < 1e-9 &&
             std::abs(std::remainder(arc.swingRadians - other.swingRadians, 2 * kPi)) < 1e-6;
    });
    EXPECT_EQ(same, 1);
  }
}

TEST(SweepWindow, lightFadesByEForEachLength) {
  const auto arcs =
      windowArcs(smallProfile(10, 8, 8), {.endRadians = 4.5 * kStep, .sweptRadians = 3 * kStep, .fadeRadians = kStep});
  ASSERT_EQ(arcs.size(), 3u);
  // The mean of exp(-x) over a step is 1 - 1 / e.
  EXPECT_NEAR(arcs[2].passes, 1 - std::exp(-1), 1e-12);
  EXPECT_NEAR(arcs[1].passes / arcs[2].passes, std::exp(-1), 1e-12);
  EXPECT_NEAR(arcs[0].passes / arcs[2].passes, std::exp(-2), 1e-12);
}

TEST(SweepWindow, aStandingScreenOrOneThatSweptNothingIsDark) {
  EXPECT_TRUE(windowArcs(smallProfile(10, 8, 8), {.endRadians = 1, .sweptRadians = 0}).empty());
}

TEST(SweepWindow, badWindowsAreInputErrors) {
  const DisplayProfile profile = smallProfile(10, 8, 8);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(windowArcs(profile, {.endRadians = nan}), InputError);
  EXPECT_THROW(windowArcs(profile, {.endRadians = 2e6}), InputError);
  EXPECT_THROW(windowArcs(profile, {.sweptRadians = -1}), InputError);
  EXPECT_THROW(windowArcs(profile, {.sweptRadians = 200}), InputError);
  EXPECT_THROW(windowArcs(profile, {.sweptRadians = nan}), InputError);
  EXPECT_THROW(windowArcs(profile, {.fadeRadians = -1}), InputError);
  EXPECT_THROW(windowArcs(profile, {.fadeRadians = std::numeric_limits<double>::infinity()}), InputError);
}

}  // namespace
}  // namespace ocelli
