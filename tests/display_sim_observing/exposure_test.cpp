#include "display_sim/observing/exposure.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

// Rounding of angles of a few turns.
constexpr double kRounding = 1e-12;

double seenDegrees(const std::vector<ExposedArc>& arcs) {
  double sum = 0;
  for (const ExposedArc& arc : arcs) {
    sum += degreesFromRadians(arc.toRadians - arc.fromRadians) * arc.passes;
  }
  return sum;
}

TEST(Exposure, aRefreshSeesEverySliceOnce) {
  for (const double end : {0.0, 30.0, -77.3}) {
    const std::vector<ExposedArc> arcs =
        exposedArcs(loadProfile("perspecta"), sweepEndingAt(loadProfile("perspecta"), 1.0 / 24, end));
    EXPECT_NEAR(seenDegrees(arcs), 180, 1e-9);
    for (const ExposedArc& arc : arcs) {
      EXPECT_EQ(arc.passes, 1);
      EXPECT_GE(arc.fromRadians, (arc.slice - 0.5) * kPi / 198 - kRounding);
      EXPECT_LE(arc.toRadians, (arc.slice + 0.5) * kPi / 198 + kRounding);
    }
  }
}

// The still camera of section 3.5.5.6.
TEST(Exposure, aTwentyFifthOfASecondMissesSevenPointTwoDegrees) {
  const DisplayProfile profile = loadProfile("perspecta");
  for (const double start : {0.0, 30.0, 175.0, -90.0}) {
    const std::vector<ExposedArc> arcs = exposedArcs(profile, sweepEndingAt(profile, 1.0 / 25, start));
    EXPECT_NEAR(seenDegrees(arcs), 180 - 7.2, 1e-9);
    for (const ExposedArc& arc : arcs) {
      EXPECT_EQ(arc.passes, 1);
      for (const double angle : {arc.fromRadians, arc.toRadians}) {
        const double past = std::fmod(degreesFromRadians(angle) - start + 720, 180);
        EXPECT_TRUE(past > 7.2 - 1e-9 || past < 1e-9 || past > 180 - 1e-9) << past << " degrees past the start";
      }
    }
  }
}

TEST(Exposure, longerThanARefreshRevisits) {
  const DisplayProfile profile = test::smallProfile(10, 16, 16);  // 24 Hz
  const std::vector<ExposedArc> arcs = exposedArcs(profile, sweepEndingAt(profile, 2.5 / 24, 90));
  EXPECT_NEAR(seenDegrees(arcs), 2.5 * 180, 1e-9);
  for (const ExposedArc& arc : arcs) {
    const double middle = degreesFromRadians(arc.fromRadians + arc.toRadians) / 2;
    EXPECT_EQ(arc.passes, middle > 0 && middle < 90 ? 3 : 2) << middle;
  }
}

TEST(Exposure, anOwnSecondHalfTurnTakesATurnToSee) {
  const DisplayProfile profile = test::smallProfile(10, 16, 16, SecondHalfTurn::kOwn);
  EXPECT_NEAR(seenDegrees(exposedArcs(profile, sweepEndingAt(profile, 1.0 / 12, 0))), 360, 1e-9);
  for (const ExposedArc& arc :
       exposedArcs(profile, sweepEndingAt(profile, 1.0 / 24, 171))) {  // a slice ends at 9.5 * 18 = 171 degrees
    EXPECT_LT(arc.slice, 10);
  }
  EXPECT_EQ(exposedArcs(profile, sweepEndingAt(profile, 1.0 / 24, 171)).size(), 10u);
}

TEST(Exposure, startsAtAnyAngle) {
  const DisplayProfile profile = loadProfile("perspecta");
  const double swept = 360 * 12 / 25.0;
  const Sweep starting = sweepStartingAt(profile, 1.0 / 25, 30);
  const Sweep ending = sweepEndingAt(profile, 1.0 / 25, 30 + swept);
  EXPECT_NEAR(starting.fromRadians, ending.fromRadians, kRounding);
  EXPECT_NEAR(starting.toRadians, ending.toRadians, kRounding);
  for (const ExposedArc& arc : exposedArcs(profile, starting)) {
    const double past = std::fmod(degreesFromRadians((arc.fromRadians + arc.toRadians) / 2) - 30 + 720, 180);
    EXPECT_LT(past, swept);
  }
}

// A half turn from the angle 0 on; then another one.
TEST(Exposure, everySecondPassIsTurned) {
  const DisplayProfile profile = test::smallProfile(10, 16, 16);
  const auto turned = [&](double fromDegrees, double toDegrees) {
    double sum = 0;
    for (const ExposedArc& arc :
         exposedArcs(profile, {radiansFromDegrees(fromDegrees), radiansFromDegrees(toDegrees)})) {
      sum += degreesFromRadians(arc.toRadians - arc.fromRadians) * arc.turnedPasses;
    }
    return sum;
  };
  EXPECT_NEAR(turned(-9, 171), 0, 1e-9);  // slice 0 starts at -9 degrees, and is turned at 171
  EXPECT_NEAR(turned(171, 351), 180, 1e-9);
  EXPECT_NEAR(turned(-9, 351), 180, 1e-9);
  EXPECT_NEAR(turned(81, 261), 90, 1e-9);
  EXPECT_NEAR(turned(-189, -9), 180, 1e-9);
  EXPECT_NEAR(turned(-9, -9 + 360 * 100), 180 * 100, 1e-6);
  for (const ExposedArc& arc : exposedArcs(test::smallProfile(10, 16, 16, SecondHalfTurn::kOwn), {0, 4 * kPi})) {
    EXPECT_EQ(arc.turnedPasses, 0) << "its slices say where the screen stands";
  }
}

TEST(Exposure, channelsInTurnHaveAThirdOfAnArcEach) {
  DisplayProfile profile = test::smallProfile(10, 16, 16);
  profile.channelTiming = ChannelTiming::kInTurn;
  double degrees[8] = {};
  for (const ExposedArc& arc : exposedArcs(profile, {0, kPi * 1.37})) {
    const double step = kPi / 10;
    const double from = arc.fromRadians - (arc.slice - 0.5) * step;
    const double to = arc.toRadians - (arc.slice - 0.5) * step;
    const int third = std::countr_zero(arc.channels);
    EXPECT_EQ(arc.channels, 1u << third);
    EXPECT_GE(from, third * step / 3 - kRounding);
    EXPECT_LE(to, (third + 1) * step / 3 + kRounding);
    degrees[arc.channels] += degreesFromRadians(arc.toRadians - arc.fromRadians) * arc.passes;
  }
  EXPECT_NEAR(degrees[1] + degrees[2] + degrees[4], 180 * 1.37, 1e-9);
  EXPECT_NEAR(degrees[1], 180 * 1.37 / 3, 18);
}

}  // namespace
}  // namespace ocelli
