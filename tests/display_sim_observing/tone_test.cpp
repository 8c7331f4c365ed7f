#include "display_sim/observing/tone.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

glm::vec3 toned(const glm::vec3& light, const Tone& tone) {
  Image<glm::vec3> image(1, 1, light);
  applyTone(image, tone);
  return image(0, 0);
}

TEST(Tone, automaticGainTakesTheBrightToNearWhite) {
  Image<glm::vec3> light(10, 30, glm::vec3(0));
  for (size_t i = 0; i < 201; ++i) {
    light[i] = glm::vec3(0, 0, static_cast<float>(i + 1));
  }
  EXPECT_DOUBLE_EQ(automaticGain(light), 0.95 / 199) << "the 99th percentile of 1 ... 201";
  EXPECT_EQ(automaticGain(Image<glm::vec3>(4, 4, glm::vec3(0))), 1);
}

TEST(Tone, darkImagesDoNotCountForACommonGain) {
  const Image<glm::vec3> dark(4, 4, glm::vec3(0));
  CommonGain common;
  common.add(dark);
  EXPECT_EQ(common.gain(), 1);
  common.add(Image<glm::vec3>(4, 4, glm::vec3(0.01f)));
  common.add(dark);
  EXPECT_NEAR(common.gain(), 95, 1e-4) << "of floats, which are exact to 6e-8";
  common.add(Image<glm::vec3>(4, 4, glm::vec3(0.5f)));
  EXPECT_EQ(common.gain(), 1.9);
}

TEST(Tone, gainComesBeforeGamma) {
  EXPECT_FLOAT_EQ(toned({0, 0, 8}, {.gain = 0.5, .gamma = 2}).z, 2);
  EXPECT_EQ(toned({0, 0.25f, 8}, {}), glm::vec3(0, 0.25f, 8));
}

TEST(Tone, reinhardKeepsColors) {
  // Luminance 0.2126 x 2 + 0.7152 x 4 + 0.0722 x 0 = 3.286, of which 1 / 4.286 is left.
  const glm::vec3 tone = toned({1, 2, 0}, {.gain = 2, .curve = ToneCurve::kReinhard});
  EXPECT_FLOAT_EQ(tone.x, 2 / 4.286f);
  EXPECT_FLOAT_EQ(tone.y, 4 / 4.286f);
  EXPECT_EQ(tone.z, 0);
  EXPECT_LT(toned(glm::vec3(1e4f), {.curve = ToneCurve::kReinhard}).x, 1);
}

TEST(Tone, filmicIsTheFit) {
  const glm::vec3 tone = toned({0, 1, 0.5f}, {.curve = ToneCurve::kFilmic});
  EXPECT_EQ(tone.x, 0);
  EXPECT_FLOAT_EQ(tone.y, 2.54f / 3.16f);
  EXPECT_FLOAT_EQ(tone.z, 0.5f * (1.255f + 0.03f) / (0.5f * (1.215f + 0.59f) + 0.14f));
}

}  // namespace
}  // namespace ocelli
