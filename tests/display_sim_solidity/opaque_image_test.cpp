#include "display_sim/solidity/opaque_image.h"

#include <gtest/gtest.h>

#include "display_sim/observing/eye_perspective.h"
#include "oc_core/image/color.h"
#include "tests/display_sim_slicing/test_meshes.h"

namespace ocelli {
namespace {

// Seen by the observer and here, a small ball has its middle at the same place. Its image is some ten pixels wide, so
// the mean of its pixels is known to a few hundredths of one.
TEST(OpaqueImage, showsThingsWhereTheObserverSeesThem) {
  const glm::dvec3 center(0.4, 0.3, -0.2);
  const Mesh ball = test::sphere(0.05, 40, center);
  for (const glm::vec3 eye : {glm::vec3(0, 0, 10), glm::vec3(3, 2, 8), glm::vec3(0, 6, 0), glm::vec3(-4, -1, -3)}) {
    const ObserverOptions options{.eye = eye, .width = 240, .height = 200};
    const Image<Rgb8> image = opaqueImage(ball, options);
    glm::dvec2 sum(0);
    double weight = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const double light = linearFromSrgbByte(image(x, y).x);
        sum += light * glm::dvec2(x + 0.5, y + 0.5);
        weight += light;
      }
    }
    const EyePerspective perspective(options);
    const glm::dvec2 expected = perspective.pixel(perspective.point(center));
    EXPECT_NEAR(sum.x / weight, expected.x, 0.05);
    EXPECT_NEAR(sum.y / weight, expected.y, 0.05);
  }
}

// A wall whose rim cuts pixels in half: 100 pixels hold tan(asin(0.1)) x 10 radii.
TEST(OpaqueImage, pixelsHoldTheMeanOfTheirSamples) {
  const auto edge = static_cast<float>(10 * std::tan(std::asin(0.1)) * 20.5 / 100);
  const Mesh wall = test::box({-edge, -edge, -0.001f}, {edge, edge, 0});
  const Image<Rgb8> image = opaqueImage(wall, {.width = 200, .height = 200});
  EXPECT_EQ(image(100, 100), Rgb8(255));
  EXPECT_EQ(image(120, 100), Rgb8(srgbByteFromLinear(0.5f)));
  EXPECT_EQ(image(120, 120), Rgb8(srgbByteFromLinear(0.25f)));
  EXPECT_EQ(image(121, 100), Rgb8(0));
}

}  // namespace
}  // namespace ocelli
