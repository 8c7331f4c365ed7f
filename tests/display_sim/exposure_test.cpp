#include "display_sim/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "tests/display_sim/test_profiles.h"

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
    const std::vector<ExposedArc> arcs = exposedArcs(loadProfile("perspecta"), 1.0 / 24, end);
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
    const std::vector<ExposedArc> arcs = exposedArcs(profile, 1.0 / 25, start);
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
  const std::vector<ExposedArc> arcs = exposedArcs(profile, 2.5 / 24, 90);
  EXPECT_NEAR(seenDegrees(arcs), 2.5 * 180, 1e-9);
  for (const ExposedArc& arc : arcs) {
    const double middle = degreesFromRadians(arc.fromRadians + arc.toRadians) / 2;
    EXPECT_EQ(arc.passes, middle > 0 && middle < 90 ? 3 : 2) << middle;
  }
}

TEST(Exposure, anOwnSecondHalfTurnTakesATurnToSee) {
  const DisplayProfile profile = test::smallProfile(10, 16, 16, SecondHalfTurn::kOwn);
  EXPECT_NEAR(seenDegrees(exposedArcs(profile, 1.0 / 12, 0)), 360, 1e-9);
  for (const ExposedArc& arc : exposedArcs(profile, 1.0 / 24, 171)) {  // a slice ends at 9.5 * 18 = 171 degrees
    EXPECT_LT(arc.slice, 10);
  }
  EXPECT_EQ(exposedArcs(profile, 1.0 / 24, 171).size(), 10u);
}

}  // namespace
}  // namespace ocelli
