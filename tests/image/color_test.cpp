#include "oc_core/image/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oc_core/image/color_text.h"

namespace ocelli {
namespace {

TEST(Color, ByteRoundTripIsExact) {
  for (int byte = 0; byte < 256; ++byte) {
    EXPECT_EQ(srgbByteFromLinear(linearFromSrgbByte(static_cast<uint8_t>(byte))), byte);
  }
}

TEST(Color, MatchesTheStandardAtKnownPoints) {
  EXPECT_EQ(linearFromSrgb(0.0f), 0.0f);
  // pow() is good to a few units in the last place of a float.
  EXPECT_NEAR(linearFromSrgb(1.0f), 1.0f, 1e-6f);
  // (0.5 + 0.055) / 1.055 to the power 2.4, and its inverse, by hand.
  EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404114f, 1e-6f);
  EXPECT_NEAR(srgbFromLinear(0.21404114f), 0.5f, 1e-6f);
  // On the linear segment: value / 12.92.
  EXPECT_FLOAT_EQ(linearFromSrgb(0.04f), 0.04f / 12.92f);
}

TEST(Color, SegmentsMeet) {
  // The standard's rounded constants leave a step of 3e-8 in the linear value there.
  EXPECT_NEAR(linearFromSrgb(0.04045f), linearFromSrgb(std::nextafter(0.04045f, 1.0f)), 1e-7f);
}

TEST(Color, GrowsMonotonically) {
  float previous = -1;
  for (int i = 0; i <= 1000; ++i) {
    const float encoded = srgbFromLinear(static_cast<float>(i) / 1000);
    EXPECT_GT(encoded, previous);
    previous = encoded;
  }
}

TEST(Color, BytesClampWhatIsOutOfRange) {
  EXPECT_EQ(srgbByteFromLinear(-0.5f), 0);
  EXPECT_EQ(srgbByteFromLinear(2.0f), 255);
  EXPECT_EQ(srgbByteFromLinear(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgbByteFromLinear(-std::numeric_limits<float>::infinity()), 0);
  EXPECT_EQ(srgbByteFromLinear(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Color, VectorIsChannelByChannel) {
  const glm::vec3 linear = linearFromSrgb(glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(linear.x, linearFromSrgb(0.25f));
  EXPECT_EQ(linear.y, linearFromSrgb(0.5f));
  EXPECT_EQ(linear.z, linearFromSrgb(0.75f));
}

TEST(Color, TextsAreSixHexadecimalDigits) {
  const glm::vec3 orange(1, linearFromSrgbByte(0x80), linearFromSrgbByte(0x0a));
  EXPECT_EQ(linearFromColorText("#ff800a"), orange);
  EXPECT_EQ(linearFromColorText("#FF800A"), orange);
  for (const char* text : {"", "#", "ff800a", "#ff800", "#ff800a0", "#ff80 a", "#ff80-a", "#ff80gg", " #ff800"}) {
    EXPECT_FALSE(linearFromColorText(text)) << text;
  }
}

}  // namespace
}  // namespace ocelli
