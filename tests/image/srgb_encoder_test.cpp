#include "oc_core/image/srgb_encoder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

TEST(SrgbEncoder, everyFloatNearAStepHasTheByteOfTheFunction) {
  const SrgbEncoder encoder;
  uint8_t last = 0;
  size_t steps = 0;
  // Floats of [0, 1] in their order, 997 bit patterns apart; around each step all of them.
  constexpr uint32_t kOne = 0x3f800000;
  for (uint32_t bits = 0; bits <= kOne; bits += 997) {
    const float value = std::bit_cast<float>(bits);
    const uint8_t byte = srgbByteFromLinear(value);
    ASSERT_EQ(encoder.byteFromLinear(value), byte) << value;
    if (byte != last) {
      ++steps;
      for (uint32_t near = bits - 997; near < bits; ++near) {
        const float between = std::bit_cast<float>(near);
        ASSERT_EQ(encoder.byteFromLinear(between), srgbByteFromLinear(between)) << between;
      }
      last = byte;
    }
  }
  EXPECT_EQ(steps, 255u);
}

TEST(SrgbEncoder, valuesOutOfRangeAreClamped) {
  const SrgbEncoder encoder;
  EXPECT_EQ(encoder.byteFromLinear(-1), 0);
  EXPECT_EQ(encoder.byteFromLinear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(encoder.byteFromLinear(2), 255);
  EXPECT_EQ(encoder.byteFromLinear(std::numeric_limits<float>::infinity()), 255);
}

}  // namespace
}  // namespace ocelli
