#include "display_sim/viewer/view_motion.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {
namespace {

constexpr float kRounding = 1e-4f;  // single precision at a distance of 10

void expectNear(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), kRounding) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(ViewMotion, aQuarterTurnToTheRightSeesFromTheRight) {
  const View moved = orbited(View{}, kPi / 2, 0);
  expectNear(moved.eye, {10, 0, 0});
  expectNear(moved.target, {0, 0, 0});
  EXPECT_NEAR(moved.fovVerticalDegrees, View{}.resolvedFovVerticalDegrees(), 1e-12);
}

TEST(ViewMotion, turningUpSeesFromAbove) {
  expectNear(orbited(View{}, 0, kPi / 6).eye, {0, 5, 10 * std::sqrt(0.75f)});
}

TEST(ViewMotion, turningKeepsTheDistance) {
  View view;
  view.eye = {3, -2, 5};
  view.target = {1, 1, 0};
  view.up = {0.2f, 1, 0.1f};
  const float distance = glm::distance(view.eye, view.target);
  for (int i = 0; i < 100; ++i) {
    view = orbited(view, 0.3, i % 2 == 0 ? 0.2 : -0.1);
    EXPECT_NEAR(glm::distance(view.eye, view.target), distance, 1e-3f);
  }
}

TEST(ViewMotion, thePolesAreNeverReached) {
  for (const double up : {10.0, -10.0}) {
    const View moved = orbited(View{}, 0, up);
    EXPECT_NO_THROW(validate(moved, "view"));
    EXPECT_GT(glm::length(glm::vec2(moved.eye.x, moved.eye.z)), 0.1f);
    EXPECT_EQ(moved.eye.y > 0, up > 0);
    EXPECT_NO_THROW(validate(orbited(moved, 1, up), "view"));
  }
}

TEST(ViewMotion, theTargetMovesByTheShareOfTheImageThatIsAskedFor) {
  const View moved = panned(View{}, 0.25, 0.5);
  const PinholeCamera camera(moved, 200, 100);
  const ImagePoint old = *camera.project({0, 0, 0});  // a quarter of 100 pixels to the left, half down
  EXPECT_NEAR(old.u, 100 - 25, 1e-2);
  EXPECT_NEAR(old.v, 50 + 50, 1e-2);
}

TEST(ViewMotion, zoomingGoesTowardsTheTargetWithinLimits) {
  expectNear(zoomed(View{}, 0.5).eye, {0, 0, 5});
  EXPECT_NEAR(glm::length(zoomed(View{}, 1e-9).eye), kMinViewDistance, 1e-6f);
  EXPECT_NEAR(glm::length(zoomed(View{}, 1e9).eye), kMaxViewDistance, 1e-2f);
}

TEST(ViewMotion, theTargetStaysWhereNumbersArePrecise) {
  View view = View{};
  for (int i = 0; i < 100000 && glm::length(view.target) < 2 * kFarthestTarget; ++i) {
    view = panned(view, 1, 0);
  }
  EXPECT_LE(glm::length(view.target), kFarthestTarget);
  EXPECT_NO_THROW(validate(view, "view"));
}

}  // namespace
}  // namespace ocelli
