#include "oc_core/remote/client/view_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/remote_client/client_scenes.h"

namespace ocelli {
namespace {

double zoomOf(const View& view) {
  return 1 / std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2);
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-4f) {
  EXPECT_LE(glm::distance(a, b), tolerance)
      << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

TEST(ViewMotion, isWhatChangesInASecond) {
  const View before = clientView(20);
  View after = clientTurned(before, 3, 0);
  after.eye += glm::vec3(0.1f, 0, 0);
  after.target += glm::vec3(0.1f, 0, 0);
  const ViewMotion motion = motionBetween(before, after, 0.5);
  expectNear(motion.eyePerSecond, {0.2f, 0, 0}, 1e-5f);
  // To the right is clockwise, seen from above.
  expectNear(motion.turnPerSecond, {0, -static_cast<float>(radiansFromDegrees(6)), 0}, 1e-5f);
  EXPECT_NEAR(motion.zoomPerSecond, 0, 1e-9);
  EXPECT_TRUE(motionBetween(before, before, 0.5).isResting());
  EXPECT_TRUE(motionBetween(before, after, 0).isResting());
  EXPECT_FALSE(motion.isResting());
}

TEST(ViewMotion, goesOn) {
  const View before = clientView(40);
  View now = clientTurned(before, 2, 1);
  now.eye += glm::vec3(0, 0, -0.2f);
  now.target += glm::vec3(0, 0, -0.2f);
  const View ahead = viewAhead(now, motionBetween(before, now, 1), 2);
  // About the same axis by three times the angle in all.
  const glm::vec3 axis =
      glm::normalize(glm::cross(glm::normalize(before.target - before.eye), glm::normalize(now.target - now.eye)));
  const glm::vec3 forward = glm::normalize(ahead.target - ahead.eye);
  // "Up" is kept, which rolls the view by half the product of both angles.
  EXPECT_NEAR(glm::dot(forward, axis), 0, 3e-4);
  const double step =
      std::acos(glm::dot(glm::normalize(before.target - before.eye), glm::normalize(now.target - now.eye)));
  EXPECT_NEAR(std::acos(glm::dot(forward, glm::normalize(before.target - before.eye))), 3 * step, 1e-4);
  expectNear(ahead.eye, now.eye + glm::vec3(0, 0, -0.4f));
  EXPECT_NEAR(glm::distance(ahead.eye, ahead.target), glm::distance(now.eye, now.target), 1e-4);
}

TEST(ViewMotion, zoomsByTheSameFactorEachSecond) {
  const View before = clientView(20);
  const View now = clientView(degreesFromRadians(2 * std::atan(std::tan(radiansFromDegrees(10)) / 1.1)));
  const View ahead = viewAhead(now, motionBetween(before, now, 1), 3);
  EXPECT_NEAR(zoomOf(ahead) / zoomOf(now), std::pow(1.1, 3), 1e-6);
}

TEST(ViewMotion, doesNotGoOnForLongWhenItIsFast) {
  const View before = clientView(20);
  const View turned = viewAhead(before, motionBetween(before, clientTurned(before, 5, 0), 0.1), 4);
  const double angle = std::acos(glm::dot(glm::normalize(turned.target - turned.eye), glm::vec3(0, 0, -1)));
  EXPECT_NEAR(degreesFromRadians(angle), 10, 0.01);
  const View zoomed = viewAhead(before, motionBetween(before, clientView(15), 0.1), 4);
  EXPECT_NEAR(zoomOf(zoomed) / zoomOf(before), 2, 1e-6);
  const View out = viewAhead(before, motionBetween(before, clientView(30), 0.1), 4);
  EXPECT_NEAR(zoomOf(out) / zoomOf(before), 0.5, 1e-6);
}

}  // namespace
}  // namespace ocelli
