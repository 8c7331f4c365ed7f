#include "display_sim/solidity/exposure_fit.h"

#include <gtest/gtest.h>

#include "display_sim/observing/observer.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

Image<glm::vec3> ramp() {
  Image<glm::vec3> light(64, 4, glm::vec3(0));
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 64; ++x) {
      light(x, y) = glm::vec3(static_cast<float>(x) / 64, static_cast<float>(x * y) / 256, 0.3f);
    }
  }
  return light;
}

// A byte of sRGB is rounded by at most half a level of 255, about a hundredth of the middle of the ramp in linear
// light; the mean over hundreds of pixels has much less.
TEST(FittedGain, undoesAFactor) {
  const Image<Rgb8> image = srgbFromLinear(ramp());
  for (const double factor : {0.001, 0.4, 1.0, 30.0}) {
    Image<glm::vec3> light = ramp();
    applyTone(light, {.gain = factor});
    EXPECT_NEAR(fittedGain(light, image) * factor, 1, 0.002) << factor;
  }
}

TEST(FittedGain, noOtherGainIsBetter) {
  Image<glm::vec3> light = ramp();
  for (int x = 0; x < 64; x += 3) {
    light(x, 1) *= 9.0f;  // too bright, which is cut off
    light(x, 2) = glm::vec3(0);
  }
  const Image<Rgb8> image = srgbFromLinear(ramp());
  const auto errorOf = [&](double gain) {
    double sum = 0;
    for (size_t i = 0; i < light.size(); ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const float shown = srgbFromLinear(std::min(light[i][channel] * static_cast<float>(gain), 1.0f));
        sum += std::pow(shown - static_cast<float>(image[i][channel]) / 255, 2);
      }
    }
    return sum;
  };
  const double gain = fittedGain(light, image);
  for (double other = gain / 16; other < gain * 16; other *= 1.1) {
    EXPECT_LE(errorOf(gain), errorOf(other)) << other;
  }
}

TEST(FittedGain, isOneWithoutLight) {
  EXPECT_EQ(fittedGain(Image<glm::vec3>(3, 2, glm::vec3(0)), Image<Rgb8>(3, 2, Rgb8(200))), 1);
}

}  // namespace
}  // namespace ocelli
