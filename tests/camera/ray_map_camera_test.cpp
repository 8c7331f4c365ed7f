#include "oc_core/camera/ray_map_camera.h"

#include <gtest/gtest.h>

#include <random>

#include "oc_core/camera/panorama_camera.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/camera/test_ray_maps.h"

namespace ocelli::test {
namespace {

glm::vec2 centre(int x, int y) {
  return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

/// All pixels have the camera's own rays, to the last bit.
template <Camera C>
void expectSamePixels(const C& camera) {
  const RayMapCamera map = cameraOf(mapOfCamera(camera));
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      ASSERT_EQ(map.rayPath(centre(x, y)), camera.rayPath(centre(x, y))) << x << ", " << y;
    }
  }
}

TEST(RayMapCamera, pixelCentresHaveTheirOwnRays) {
  expectSamePixels(smallCamera());
  expectSamePixels(crossroads());
  expectSamePixels(bendingTwice());
}

TEST(RayMapCamera, aPinholesRaysAreMetBetweenPixelsToo) {
  const PinholeCamera pinhole = smallCamera();
  const RayMapCamera map = cameraOf(mapOfCamera(pinhole));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec2 pixel(share(random) * kWidth, share(random) * kHeight);
    const RayPath got = map.rayPath(pixel);
    const RayPath want = pinhole.rayPath(pixel);
    ASSERT_EQ(got.size(), 2u);
    // Points at distances of 10 and 1000 are rounded by half of 1e-6 and of 6e-5; neighbours add up to twice that.
    EXPECT_LT(glm::distance(got.front(), want.front()), 3e-6f) << pixel.x << ", " << pixel.y;
    EXPECT_LT(glm::distance(got.back(), want.back()), 4e-4f) << pixel.x << ", " << pixel.y;
    EXPECT_EQ(got.tMin(), want.tMin());
    EXPECT_EQ(got.tMax(), want.tMax());
  }
  for (const glm::vec2 outside : {glm::vec2(-0.1f, 5), glm::vec2(5, kHeight + 0.1f)}) {
    EXPECT_TRUE(map.rayPath(outside).empty());
    EXPECT_FALSE(map.unproject({outside.x, outside.y, 10}));
  }
}

TEST(RayMapCamera, anImageOfAnotherSizeStretchesTheRays) {
  const PinholeCamera pinhole = smallCamera();
  const auto map = std::make_shared<const RayMap>(mapOfCamera(pinhole));
  const RayMapCamera twice(map, {2 * kWidth, 2 * kHeight});
  EXPECT_EQ(twice.width(), 2 * kWidth);
  for (const glm::vec2 pixel : {glm::vec2(0.5f, 0.5f), glm::vec2(33.5f, 70.5f), glm::vec2(2 * kWidth, 2 * kHeight)}) {
    const std::optional<glm::vec3> point = twice.unproject({pixel.x, pixel.y, 10});
    ASSERT_TRUE(point);
    const std::optional<ImagePoint> q = pinhole.project(*point);
    ASSERT_TRUE(q);
    // At z = 10 a coordinate that is off by rounding, 1e-6, moves by 1e-6 f / z: f is 300 pixels.
    EXPECT_NEAR(q->u * 2, pixel.x, 1e-4f);
    EXPECT_NEAR(q->v * 2, pixel.y, 1e-4f);
    const std::optional<ImagePoint> back = twice.project(*point);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->u, pixel.x, 2e-4f);
    EXPECT_NEAR(back->v, pixel.y, 2e-4f);
    EXPECT_NEAR(back->t, 10, 1e-5f);
  }
}

TEST(RayMapCamera, stretchedImagesReachTheirBorders) {
  const auto map = std::make_shared<const RayMap>(mapOfCamera(smallCamera()));
  for (int side = 1; side < 400; ++side) {
    const RayMapCamera camera(map, {side, side});
    const auto end = static_cast<float>(side);
    EXPECT_FALSE(camera.rayPath({end, end}).empty()) << side;
    EXPECT_FALSE(camera.rayPath({0, 0}).empty()) << side;
    EXPECT_TRUE(camera.rayPath({end * 1.001f, 0}).empty()) << side;
  }
}

TEST(RayMapCamera, besidePixelsWithoutRaysTheNearestPixelCounts) {
  const RayMapCamera fisheye = cameraOf(fisheyeMap(40));
  EXPECT_TRUE(fisheye.rayPath({0.5f, 0.5f}).empty()) << "a corner";
  EXPECT_TRUE(fisheye.rayPath({0.7f, 0.6f}).empty());
  EXPECT_FALSE(fisheye.unproject({0.7f, 0.6f, 5}));
  int beside = 0;
  for (int x = 0; x < 20; ++x) {
    const glm::vec2 pixel = centre(x, 6);
    if (!fisheye.rayPath(pixel).empty() && fisheye.rayPath(pixel - glm::vec2(1, 0)).empty()) {
      EXPECT_EQ(fisheye.rayPath(pixel - glm::vec2(0.3f, 0)), fisheye.rayPath(pixel));
      EXPECT_TRUE(fisheye.rayPath(pixel - glm::vec2(0.7f, 0)).empty());
      ++beside;
    }
  }
  EXPECT_EQ(beside, 1);
}

TEST(RayMapCamera, aFisheyeSeesPointsWhereTheyAre) {
  const RayMapCamera fisheye = cameraOf(fisheyeMap(200));
  // 45 degrees to the right of the view: half way from the middle to the border.
  const std::optional<ImagePoint> q = fisheye.project({2, 0, 8});
  ASSERT_TRUE(q);
  // Between pixels directions are bilinear: they are off by 1/8 of the square of a pixel's angle, 90 / 100 degrees,
  // 3e-5, of which a pixel is 0.0157.
  EXPECT_NEAR(q->u, 150, 3e-3f);
  EXPECT_NEAR(q->v, 100, 3e-3f);
  EXPECT_NEAR(q->t, std::sqrt(8.0), 2e-4);
  EXPECT_FALSE(fisheye.project({0, 0, 12})) << "behind";
}

TEST(RayMapCamera, aPushBroomHasItsColumnsSideBySide) {
  const RayMapCamera camera = cameraOf(pushBroomMap({80, 50}));
  for (const double x : {-1.9, -0.3, 1.2}) {
    const std::optional<ImagePoint> q = camera.project(glm::vec3(x, 0, 4));
    ASSERT_TRUE(q);
    EXPECT_NEAR(q->u, (x + 2) / 4 * 80, 1e-4);
    EXPECT_NEAR(q->v, 25, 1e-4);
    // Half way between two rows, 0.4 / 50 apart, the mean of their unit vectors is as short as the cosine of half that.
    EXPECT_NEAR(q->t, 6 / std::cos(0.004), 1e-5);
  }
  EXPECT_FALSE(camera.project({2.1f, 0, 4}));
}

TEST(RayMapCamera, whatIsSeenTwiceHasItsNearestImage) {
  // Both columns pass the origin: the first one after 3, the second after 2.
  const RayMapCamera camera = cameraOf(straightMap({4, 2}, [](double u, double v) {
    const double y = v - 1;
    const bool left = u < 2;
    return std::pair(glm::dvec3(u - (left ? 1 : 3), y, left ? 3 : -2), glm::dvec3(0, 0, left ? -1 : 1));
  }));
  const std::optional<ImagePoint> q = camera.project({0, 0, 0});
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->u, 3, 1e-5f);
  EXPECT_NEAR(q->v, 1, 1e-5f);
  EXPECT_NEAR(q->t, 2, 1e-5f);
}

TEST(RayMapCamera, anImageThatWrapsAroundHasNoSeam) {
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  view.fovVerticalDegrees = 60;
  const PanoramaCamera panorama(PinholeCamera(view, 64, 32));
  const RayMapCamera map = cameraOf(mapOfCamera(panorama, {.wrapsAround = true}));
  for (const float u : {0.0f, 0.25f, 63.6f, 64.0f}) {
    const std::optional<glm::vec3> point = map.unproject({u, 16, 5});
    ASSERT_TRUE(point) << u;
    const std::optional<ImagePoint> exact = panorama.project(*point);
    ASSERT_TRUE(exact);
    // Chords of 360 / 64 degrees: the direction is off by less than 1/8 of its square, which is 0.012 pixels.
    EXPECT_NEAR(std::remainder(static_cast<double>(exact->u) - u, 64.0), 0, 0.012) << u;
    const std::optional<ImagePoint> back = map.project(*point);
    ASSERT_TRUE(back) << u;
    EXPECT_NEAR(std::remainder(static_cast<double>(back->u) - u, 64.0), 0, 1e-4) << u;
  }
}

TEST(RayMapCamera, anImageOfOneRowGivesRaysAndNoImagesOfPoints) {
  const RayMapCamera line = cameraOf(pushBroomMap({16, 1}));
  EXPECT_EQ(line.rayPath({3.5f, 0.5f}).size(), 2u);
  EXPECT_EQ(line.rayPath({3.7f, 0.2f}).size(), 2u);
  EXPECT_FALSE(line.project({0, 0, 4}));
}

/// What the hierarchy finds is what all quads one after the other give.
void expectSearchFindsAll(const RayMapCamera& camera, const glm::vec3& lower, const glm::vec3& upper, int points,
                          int least) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(0, 1);
  int seen = 0;
  for (int i = 0; i < points; ++i) {
    const glm::vec3 point = lower + (upper - lower) * glm::vec3(share(random), share(random), share(random));
    const std::optional<ImagePoint> slow = camera.projectSlowly(point);
    const std::optional<ImagePoint> fast = camera.project(point);
    ASSERT_EQ(fast.has_value(), slow.has_value()) << point.x << ", " << point.y << ", " << point.z;
    if (slow) {
      ++seen;
      EXPECT_EQ(fast->u, slow->u);
      EXPECT_EQ(fast->v, slow->v);
      EXPECT_EQ(fast->t, slow->t);
    }
  }
  EXPECT_GE(seen, least) << "of " << points;
}

TEST(RayMapCamera, theHierarchyMissesNoQuad) {
  const PinholeCamera pinhole(View{}, 27, 18);
  expectSearchFindsAll(cameraOf(mapOfCamera(pinhole)), {-2, -1.5f, -2}, {2, 1.5f, 9.9f}, 300, 50);
  expectSearchFindsAll(cameraOf(fisheyeMap(30)), {-5, -5, 0}, {5, 5, 10}, 300, 200);
  expectSearchFindsAll(cameraOf(pushBroomMap({33, 20})), {-2, -2, -5}, {2, 2, 9}, 300, 200);
  expectSearchFindsAll(cameraOf(mapOfCamera(crossroads(pinhole))), {-3, -2, -6}, {3, 2, 6}, 200, 30);
  expectSearchFindsAll(cameraOf(mapOfCamera(bendingTwice(pinhole))), {-2, -2, -4}, {2, 2, 6}, 100, 10);
  for (unsigned seed = 1; seed <= 6; ++seed) {
    expectSearchFindsAll(cameraOf(randomMap(seed, {23, 17})), {0, 0, 0.5f}, {7, 5, 4}, 300, 50);
  }
}

TEST(RayMapCamera, raysOfRandomMapsHaveTheirPointsWhereTheyPass) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const RayMapCamera camera = cameraOf(randomMap(seed, {19, 13}));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(0, 1);
    int passed = 0;
    for (int i = 0; i < 500; ++i) {
      const glm::vec2 pixel(share(random) * 19, share(random) * 13);
      const RayPath ray = camera.rayPath(pixel);
      if (ray.empty()) {
        continue;
      }
      const glm::vec3 point = ray.pointAt({0, share(random)});
      const std::optional<ImagePoint> q = camera.project(point);
      if (!q) {
        continue;  // of a pixel beside some without rays
      }
      ++passed;
      const std::optional<glm::vec3> back = camera.unproject(*q);
      ASSERT_TRUE(back);
      // t is rounded to single precision, and so are pixels, of 0.3 here.
      EXPECT_LT(glm::distance(*back, point), 1e-5f) << "another ray may pass there too, but one that does";
    }
    EXPECT_GT(passed, 100);
  }
}

}  // namespace
}  // namespace ocelli::test
