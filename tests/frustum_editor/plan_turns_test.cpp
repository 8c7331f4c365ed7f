#include "oc_core/frustum_editor/plan_turns.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kTurnRounding = 1e-12;  // of sines and cosines, and of products of a few of them

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), kTurnRounding) << a.x << " " << a.y << " " << a.z;
}

TEST(PlanTurns, headingsAreThoseOfACompass) {
  EXPECT_NEAR(headingDegrees({0, 0, -1}), 0, kTurnRounding);
  EXPECT_NEAR(headingDegrees({1, 0, 0}), 90, kTurnRounding);
  EXPECT_NEAR(headingDegrees({0, 5, 1}), 180, kTurnRounding);
  EXPECT_NEAR(headingDegrees({-1, 0, 0}), 270, kTurnRounding);
  EXPECT_NEAR(pitchDegrees({3, 3, 0}), 45, 1e-6);  // acos and asin lose half the digits near 1, and here a few
  expectNear(directionOf(90, 0), {1, 0, 0});
  const glm::dvec3 direction = glm::normalize(glm::dvec3(-1, 0.5, 2));
  EXPECT_LT(glm::distance(directionOf(headingDegrees(direction), pitchDegrees(direction)), direction), 1e-9);
}

TEST(PlanTurns, aPlaneAcrossHoldsTheStrokeAtAnyDepth) {
  const DrawnEditPlane plane = planeAcross(PlanSide::kTop, {-2, 1, 3}, {2, 1, 1}, {0, 0, -1});
  const Plane made = Plane::through(plane.point, plane.normal);
  for (const glm::dvec3& point : {glm::dvec3(-2, 9, 3), glm::dvec3(2, -9, 1)}) {
    EXPECT_NEAR(made.height(point), 0, kTurnRounding);
  }
  EXPECT_GT(made.height({0, 0, -10}), 0);  // ahead
  EXPECT_THROW(planeAcross(PlanSide::kTop, {1, 2, 3}, {1, 5, 3}, {0, 0, -1}), InputError);
}

TEST(PlanTurns, aTurnedPlaneHoldsBothItsEnds) {
  // Tilted by 45 degrees about x: it stays as steep as it was.
  const Plane plane = Plane::through({0, 0, 0}, {0, 1, -1});
  const DrawnEditPlane turned = turnedPlane(PlanSide::kTop, plane, {0, 0, 0}, {4, 0, 0}, {4, 0, -4});
  const Plane made = Plane::through(turned.point, turned.normal);
  EXPECT_NEAR(made.height({0, 0, 0}), 0, kTurnRounding);
  EXPECT_NEAR(made.height({4, 0, -4}), 0, kTurnRounding);
  EXPECT_NEAR(turned.normal.y, std::sqrt(0.5), kTurnRounding);
}

TEST(PlanTurns, anglesArePositiveFromXToTheEyeOfThePlan) {
  // About +y, seen from above: from -z to -x is a quarter to the left.
  EXPECT_NEAR(angleOnPaper(PlanSide::kTop, {0, 0, -1}, {-1, 7, 0}), kPi / 2, kTurnRounding);
  expectNear(turnedAbout({0, 0, -1}, {0, 1, 0}, kPi / 2), {-1, 0, 0});
}

TEST(PlanTurns, coordinatesAreRoundedToWhatOneTypes) {
  EXPECT_EQ(roundedTo(1.2344, 0.001), 1.234);
  EXPECT_EQ(roundedTo(-0.0001, 0.001), 0);
  EXPECT_FALSE(std::signbit(roundedTo(-0.0001, 0.001)));
  EXPECT_EQ(roundedTo(1234.0, 100), 1200);
}

}  // namespace
}  // namespace ocelli
