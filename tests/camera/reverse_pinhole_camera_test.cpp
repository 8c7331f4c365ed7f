#include "oc_core/camera/reverse_pinhole_camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;

PinholeCamera reference(float zNear = 8, float zFar = 14) {
  View view;
  view.zNear = zNear;
  view.zFar = zFar;
  return {view, kWidth, kHeight};
}

// The eye at (0, 0, 10), z = 10 - z_world, f = 30 sqrt(99), the same image at 10, and the rays meet at 20: the opposite
// eye at (0, 0, -10), as far from the origin. A point at z is magnified by f / (20 - z) there.
TEST(ReversePinholeCamera, seesWhatThePinholeAtTheMeetingPointSees) {
  const ReversePinholeCamera camera(reference(), 10, 20);
  const double focal = kHeight / 2.0 * std::sqrt(99.0);
  for (const glm::vec3 point : {glm::vec3(0.3f, -0.2f, 0), glm::vec3(0.3f, -0.2f, 1.5f), glm::vec3(0.3f, -0.2f, -3)}) {
    const std::optional<ImagePoint> q = camera.project(point);
    ASSERT_TRUE(q);
    const double depth = 10.0 - point.z;
    EXPECT_NEAR(q->u, 45 + focal * point.x / (20 - depth), 1e-4);
    EXPECT_NEAR(q->v, 30 - focal * point.y / (20 - depth), 1e-4);
    EXPECT_NEAR(q->t, depth, 2e-6);
  }
}

TEST(ReversePinholeCamera, farThingsLookLarger) {
  const ReversePinholeCamera camera(reference(), 10, 20);
  float last = 0;
  for (const float z : {1.5f, 0.5f, 0.0f, -1.0f, -3.0f}) {
    const float size = camera.project({0.3f, 0, z})->u - 45;
    EXPECT_GT(size, last);
    last = size;
  }
}

TEST(ReversePinholeCamera, itsStraightRaysMeetBehindTheScene) {
  const ReversePinholeCamera camera(reference(), 10, 20);
  for (const glm::vec2 pixel : {glm::vec2(0.5f, 0.5f), glm::vec2(80.5f, 10.5f), glm::vec2(45, 30)}) {
    const RayPath path = camera.rayPath(pixel);
    ASSERT_EQ(path.size(), 2u);
    // On to z = 20, twice as far as the path is long.
    const glm::vec3 meeting = path[0] + (path[1] - path[0]) * 2.0f;
    EXPECT_LT(glm::distance(meeting, glm::vec3(0, 0, -10)), 1e-5f);
  }
}

// The longest displacement of anything that ends up inside of the borders, by brute force.
TEST(ReversePinholeCamera, longestDisplacementIsThatOfACorner) {
  const ReversePinholeCamera camera(reference(), 10, 20);
  float longest = 0;
  for (float z = 8; z <= 14; z += 0.25f) {
    const std::optional<glm::vec3> point = camera.unproject({0, 0, z});
    const ImagePoint seen = camera.reference().imageFromCamera(camera.reference().cameraFromWorld(*point));
    longest = std::max(longest, glm::length(glm::vec2(seen.u, seen.v)));
  }
  EXPECT_NEAR(camera.longestDisplacement(), longest, 1e-3f);
}

TEST(ReversePinholeCamera, boundsOfDisplacementsHoldAndAreReached) {
  const ReversePinholeCamera camera(reference(), 10, 20);
  for (const ImageBox& box :
       {ImageBox{{10, 5}, {30, 25}}, ImageBox{{40, 20}, {60, 50}}, ImageBox{{50, 35}, {50, 35}}}) {
    for (const glm::vec2 z : {glm::vec2(8, 9), glm::vec2(9, 13), glm::vec2(10, 10), glm::vec2(11, 14)}) {
      const ImageBox bound = camera.displacementOver(box, 1 / z.y, 1 / z.x);
      ImageBox reached{glm::vec2(1e9f), glm::vec2(-1e9f)};
      for (const float u : {box.lower.x, box.upper.x}) {
        for (const float v : {box.lower.y, box.upper.y}) {
          for (const float depth : {z.x, z.y}) {
            const ImagePoint q = camera.distort({u, v, depth});
            reached.lower = glm::min(reached.lower, glm::vec2(q.u - u, q.v - v));
            reached.upper = glm::max(reached.upper, glm::vec2(q.u - u, q.v - v));
          }
        }
      }
      EXPECT_LT(glm::length(bound.lower - reached.lower), 1e-3f) << "bilinear: its extremes are at corners";
      EXPECT_LT(glm::length(bound.upper - reached.upper), 1e-3f);
    }
  }
}

TEST(ReversePinholeCamera, aroundPointsTheRangeHoldsThem) {
  const std::vector<glm::vec3> points{{0, 0, 1}, {0.1f, 0, -1}, {0, 0, 20}, {50, 0, -8}};  // behind; out of view
  const ReversePinholeCamera camera = ReversePinholeCamera::around(test::smallCamera(), points);
  EXPECT_FLOAT_EQ(camera.sameImageDepth(), 10);
  EXPECT_FLOAT_EQ(camera.meetingDepth(), 20);
  EXPECT_TRUE(camera.project(points[0]));
  EXPECT_TRUE(camera.project(points[1]));
}

TEST(ReversePinholeCamera, badParametersAreRefused) {
  constexpr float kBadNumber = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto refused = [](const PinholeCamera& pinhole, float same, float meeting) {
    EXPECT_THROW(ReversePinholeCamera(pinhole, same, meeting), InputError) << same << " " << meeting;
  };
  refused(reference(), 7, 20);
  refused(reference(), 15, 20);
  refused(reference(), 10, 14);
  refused(reference(), 10, -20);
  refused(reference(), kBadNumber, 20);
  refused(reference(), 10, kBadNumber);
  refused(reference(), 10, kInfinity);
  refused(reference(0.01f, 14), 10, 20);      // its frustum would be a thousand times as wide at the near end
  refused(reference(8, 14), 10, 14.000001f);  // and as narrow at the far one
  EXPECT_THROW(ReversePinholeCamera::around(test::smallCamera(), {}), InputError);
  const std::vector<glm::vec3> behind{{0, 0, 12}, {kBadNumber, 0, 0}};
  EXPECT_THROW(ReversePinholeCamera::around(test::smallCamera(), behind), InputError);
}

}  // namespace
}  // namespace ocelli
