#include "oc_core/miv/miv_samples.h"

#include <gtest/gtest.h>

#include <random>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

int levelAt(const std::string& bytes, size_t sample) {
  return static_cast<uint8_t>(bytes[2 * sample]) | static_cast<uint8_t>(bytes[2 * sample + 1]) << 8;
}

/// Y, Cb, Cr of a picture of one colour.
std::array<int, 3> levelsOf(const glm::vec3& linear) {
  const std::string bytes = mivTextureBytes(Image<glm::vec3>(4, 2, linear));
  EXPECT_EQ(bytes.size(), 4u * 2 * 3);
  return {levelAt(bytes, 0), levelAt(bytes, 8), levelAt(bytes, 10)};
}

// The levels of BT.709 for 10 bits: table 5 of the recommendation, and E'Y of its primaries.
TEST(MivSamples, coloursAreThoseOfBt709) {
  EXPECT_EQ(levelsOf({0, 0, 0}), (std::array<int, 3>{64, 512, 512}));
  EXPECT_EQ(levelsOf({1, 1, 1}), (std::array<int, 3>{940, 512, 512}));
  EXPECT_EQ(levelsOf({1, 0, 0}),
            (std::array<int, 3>{250, 409, 960}));  // 64 + 876 * 0.2126, 512 - 448 * 0.2126 / 0.9278
  EXPECT_EQ(levelsOf({0, 0, 1}),
            (std::array<int, 3>{127, 960, 471}));  // 64 + 876 * 0.0722, 512 - 448 * 0.0722 / 0.7874
}

// A step of luma is 1/876 of white, one of chroma 1/896 of twice that: less than half a hundredth of a colour.
TEST(MivSamples, coloursComeBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(0, 1);
  Image<glm::vec3> colors(16, 8);
  for (int y = 0; y < colors.height(); y += 2) {
    for (int x = 0; x < colors.width(); x += 2) {
      const glm::vec3 color(anywhere(random), anywhere(random), anywhere(random));
      colors(x, y) = colors(x + 1, y) = colors(x, y + 1) = colors(x + 1, y + 1) = color;
    }
  }
  const Image<glm::vec3> back = colorsOfMivTexture(mivTextureBytes(colors), 16, 8);
  for (size_t i = 0; i < colors.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(srgbFromLinear(back[i][channel]), srgbFromLinear(colors[i][channel]), 0.005f);
    }
  }
}

TEST(MivSamples, depthsAreStepsOfInverseDepth) {
  Image<float> depth(2, 2, 0);
  depth(0, 0) = 2;
  depth(1, 0) = 8;
  depth(0, 1) = 16.0f / 5;  // half way in 1/z
  const MivDepthRange range{2, 8};
  const std::string bytes = mivDepthBytes(depth, range, 1);
  EXPECT_EQ(levelAt(bytes, 0), 65535);
  EXPECT_EQ(levelAt(bytes, 1), 1);  // 0 is nothing
  EXPECT_NEAR(levelAt(bytes, 2), 32768, 1);
  EXPECT_EQ(levelAt(bytes, 3), 0);
  EXPECT_EQ(levelAt(bytes, 4), 32768);
  EXPECT_EQ(levelAt(bytes, 5), 32768);
  const Image<float> back = depthsOfMivDepth(bytes, 2, 2, range, 1);
  const double step = (1.0 / 2 - 1.0 / 8) / 65535;
  EXPECT_EQ(back(1, 1), 0);
  for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
    EXPECT_NEAR(1 / back(at.x, at.y), 1 / depth(at.x, at.y), 1.01 * step);
  }
}

TEST(MivSamples, depthsAreInMetres) {
  const Image<float> depth(2, 2, 20);
  const MivDepthRange range{1, 4};
  EXPECT_NEAR(depthsOfMivDepth(mivDepthBytes(depth, range, 10), 2, 2, range, 10)(0, 0), 20, 1e-2);
  EXPECT_NEAR(depthsOfMivDepth(mivDepthBytes(depth, range, 10), 2, 2, range, 1)(0, 0), 2, 1e-3);
}

}  // namespace
}  // namespace ocelli
