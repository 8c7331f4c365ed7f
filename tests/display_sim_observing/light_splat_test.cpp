#include "display_sim/observing/light_splat.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/conventions.h"
#include "tests/display_sim_dither/light_measures.h"

namespace ocelli {
namespace {

Image<glm::vec3> imageOf(const LightImage& light, int width, int height) {
  Image<glm::vec3> image(width, height);
  for (size_t i = 0; i < image.size(); ++i) {
    const FixedLight& pixel = light.pixels()[i];
    image[i] = glm::dvec3(pixel[0], pixel[1], pixel[2]) / kLightUnit;
  }
  return image;
}

// Shares are rounded to 2^-24 each, and 60 x 60 pixels have one at most.
constexpr double kSplatRounding = 3600.0 / (1 << 24);

TEST(LightSplat, aBoxIsExact) {
  LightImage light(4, 3);
  light.addBox(1.5, 1, 2, 1, 8, {1, 0.5, 0});
  const Image<glm::vec3> image = imageOf(light, 4, 3);
  EXPECT_EQ(image(0, 0), glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(image(1, 1), glm::vec3(2, 1, 0));
  EXPECT_EQ(image(2, 1), glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(image(3, 1), glm::vec3(0));
  EXPECT_EQ(image(1, 2), glm::vec3(0));
}

// The variance of an ellipse is diameter^2 / 16, and that of a pixel, to whose centre all of its light counts, 1 / 12.
// Rows are filled with boxes as large as their part of the ellipse: that moves light by less than a pixel where the rim
// is flat, 1 % of the variance at 20 pixels.
TEST(LightSplat, anEllipseHasItsAreaAndSpread) {
  for (const glm::dvec2& at : {glm::dvec2(30, 30), glm::dvec2(30.3, 29.8)}) {
    LightImage light(60, 60);
    light.addEllipse(at.x, at.y, 40, 20, 5, {1, 1, 1});
    const Image<glm::vec3> image = imageOf(light, 60, 60);
    EXPECT_NEAR(test::sumOf(image).x, 5, kSplatRounding);
    const test::Spread spread = test::spreadOf(image);
    EXPECT_NEAR(spread.center.x, at.x, 1e-3);
    EXPECT_NEAR(spread.center.y, at.y, 1e-3);
    EXPECT_NEAR(spread.variance.x, 40 * 40 / 16.0 + 1.0 / 12, 1);
    EXPECT_NEAR(spread.variance.y, 20 * 20 / 16.0 + 1.0 / 12, 0.25);
    EXPECT_NEAR(image(30, 30).x, 5 / (kPi / 4 * 40 * 20), 1e-5) << "evenly";
    EXPECT_EQ(image(12, 22), glm::vec3(0)) << "in the corner of its box";
  }
}

TEST(LightSplat, whatFallsOutsideIsLost) {
  LightImage light(60, 60);
  light.addEllipse(60, 0, 30, 30, 8, {1, 1, 1});
  EXPECT_NEAR(test::sumOf(imageOf(light, 60, 60)).x, 2, kSplatRounding) << "a quarter is inside";
  LightImage beside(60, 60);
  beside.addEllipse(-20, 30, 30, 30, 8, {1, 1, 1});
  beside.addEllipse(30, 90, 30, 30, 8, {1, 1, 1});
  beside.addBox(-20, 30, 30, 30, 8, {1, 1, 1});
  beside.addBox(30, -90, 30, 30, 8, {1, 1, 1});
  EXPECT_EQ(test::sumOf(imageOf(beside, 60, 60)), glm::dvec3(0));
}

TEST(LightSplat, whatHasNoPlaceOrSizeIsLost) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LightImage light(4, 3);
  for (const double bad : {nan, inf, -inf, 1e306, -1e306}) {
    light.addBox(bad, 1, 2, 2, 8, {1, 1, 1});
    light.addBox(1, bad, 2, 2, 8, {1, 1, 1});
    light.addBox(bad, bad, inf, inf, 8, {1, 1, 1});
    light.addEllipse(bad, 1, 2, 2, 8, {1, 1, 1});
    light.addEllipse(1, bad, 2, 2, 8, {1, 1, 1});
  }
  for (const double size : {nan, inf, 1e306}) {
    light.addBox(1, 1, size, size, 8, {1, 1, 1});
    light.addEllipse(1, 1, size, size, 8, {1, 1, 1});
  }
  EXPECT_EQ(test::sumOf(imageOf(light, 4, 3)), glm::dvec3(0));
}

TEST(LightSplat, tooMuchLightDoesNotWrapAround) {
  LightImage light(1, 1);
  double last = 0;
  for (int i = 0; i < 8; ++i) {
    light.addBox(0.5, 0.5, 1, 1, 1e30, {1, 1, 1});
    const auto now = static_cast<double>(light.pixels()[0][0]);
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_EQ(light.pixels()[0][0], std::numeric_limits<uint64_t>::max());
}

TEST(LightSplat, imagesOfAllThreadsShareAGiB) {
  EXPECT_EQ(lightImageCount(768, 768, 4), 4u);
  EXPECT_EQ(lightImageCount(768, 768, 200), 16u);
  EXPECT_EQ(lightImageCount(768, 768, 0), 1u);
  EXPECT_EQ(lightImageCount(4096, 2048, 16), 5u) << "192 MiB each";
  EXPECT_EQ(lightImageCount(8192, 8192, 16), 1u);
}

}  // namespace
}  // namespace ocelli
