#include "oc_core/remote/client/image_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/remote_client/client_scenes.h"

namespace ocelli {
namespace {

constexpr glm::ivec2 kScreen{160, 90};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double halfTangent(double degrees) {
  return std::tan(radiansFromDegrees(degrees) / 2);
}

ImageCover coverOf(double fovDegrees, const GpcLayout& layout = {.regions = {}}, const DepthSpan& span = {}) {
  return {PinholeCamera(clientView(fovDegrees), 2 * kScreen.x, 2 * kScreen.y), layout, span};
}

TEST(ImageCover, reachesAsFarAsTheCornersOfTheView) {
  const ImageCover image = coverOf(20);
  // Same direction: the ratio of the tangents.
  EXPECT_NEAR(coverLoad(image, clientView(10), kScreen, {}).reach, halfTangent(10) / halfTangent(20), 1e-6);
  EXPECT_NEAR(coverLoad(image, clientView(20), kScreen, {}).reach, 1, 1e-6);
  // Turned up by 5 degrees, the upper border is 10 degrees up in the middle of the image: just at its border.
  const double up = coverLoad(image, clientTurned(clientView(10), 0, 5), kScreen, {}).reach;
  EXPECT_NEAR(up, 1, 1e-5);
  EXPECT_TRUE(coverLoad(image, clientTurned(clientView(10), 0, 4.9), kScreen, {}).isCovered());
  EXPECT_FALSE(coverLoad(image, clientTurned(clientView(10), 0, 5.1), kScreen, {}).isCovered());
}

TEST(ImageCover, neverReachesBehindItself) {
  View behind = clientView(10);
  behind.target = {0, 0, 20};
  EXPECT_EQ(coverLoad(coverOf(20), behind, kScreen, {}).reach, kInfinity);
  EXPECT_EQ(coverLoad(coverOf(20), behind, kScreen, {}).detail, kInfinity);
}

TEST(ImageCover, hasTheDetailOfItsSamplesInTheMiddle) {
  // Twice as many pixels as the screen over twice the tangent: one sample a pixel, without a region.
  const CoverLimits limits{.leastDetail = 0.5};
  const double fov = degreesFromRadians(2 * std::atan(halfTangent(20) / 2));
  EXPECT_NEAR(coverLoad(coverOf(20), clientView(fov), kScreen, limits).detail, 0.5, 1e-6);
  // Three in a region of 3x, and half of that for a view of twice the size.
  const ImageCover region = coverOf(20, clientLayout(3));
  EXPECT_NEAR(coverLoad(region, clientView(fov), kScreen, limits).detail, 0.5 / 3, 1e-6);
  const double closer = degreesFromRadians(2 * std::atan(halfTangent(fov) / 2));
  EXPECT_NEAR(coverLoad(region, clientView(closer), kScreen, limits).detail, 0.5 / 1.5, 1e-6);
}

TEST(ImageCover, shiftsNearThingsBeforeFarOnes) {
  const CoverLimits limits{.leastDetail = 0.5, .largestParallax = 0.1, .largestAngle = 10};
  const ImageCover image = coverOf(40, {.regions = {}}, {8, 16});
  EXPECT_EQ(coverLoad(image, clientView(20), kScreen, limits).shift, 0);
  // 0.2 at depths of 8 and 16, in a view that is 2 tan(10) high at a depth of 1.
  const View moved = movedEye(clientView(20), {0.2f, 0, 0});
  EXPECT_NEAR(coverLoad(image, moved, kScreen, limits).shift, 0.2 * (1.0 / 8 - 1.0 / 16) / (2 * halfTangent(20)) / 0.1,
              1e-5);
  // Without depth nothing but the same eye will do.
  EXPECT_EQ(coverLoad(coverOf(40), moved, kScreen, limits).shift, kInfinity);
}

TEST(ImageCover, seesThingsFromTheirSide) {
  const CoverLimits limits{.leastDetail = 0.5, .largestParallax = 10, .largestAngle = 0.1};
  const View moved = movedEye(clientView(20), {0.2f, 0, 0});
  EXPECT_NEAR(coverLoad(coverOf(40, {.regions = {}}, {8, 16}), moved, kScreen, limits).shift, 0.2 / 8 / 0.1, 1e-5);
}

TEST(ImageCover, takesItsDepthsFromSamples) {
  ReferenceImage image = blankReferenceImage("gpc", clientView(20), 20, 10);
  EXPECT_EQ(ImageCover(image).depths.nearZ, 0);
  // 9 of 200 samples at 2, the others at 5: the twentieth part of them is 10.
  for (int i = 0; i < 200; ++i) {
    image.set(i % 20, i / 20, i < 9 ? 2.0f : 5.0f, glm::vec3(0));
  }
  EXPECT_EQ(ImageCover(image).depths.nearZ, 5);
  EXPECT_EQ(ImageCover(image).depths.farZ, 5);
  for (int i = 0; i < 11; ++i) {
    image.set(i, 0, 2, glm::vec3(0));
  }
  EXPECT_EQ(ImageCover(image).depths.nearZ, 2);
  EXPECT_EQ(ImageCover(image).depths.farZ, 5);
  EXPECT_EQ(ImageCover(image, false).depths.nearZ, 0);
}

}  // namespace
}  // namespace ocelli
