#include "display_sim/volume_slicing/swept_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

TEST(SweptCode, KeepsTheMeanToHalfAStep) {
  for (float mean = 0; mean <= 1; mean += 0.00037f) {
    EXPECT_NEAR(sweptMeanOf(sweptCode(mean, 0)), mean, 0.5001f / (kSweptMeans - 1));
  }
  EXPECT_EQ(sweptMeanOf(sweptCode(-3, 0)), 0);
  EXPECT_EQ(sweptMeanOf(sweptCode(3, 0)), 1);
}

TEST(SweptCode, KeepsTheSpreadToHalfOfAStepOfItsLogarithm) {
  constexpr float kMinSpread = kMinSweptSpread / (kSweptMeans - 1);
  for (float spread = kMinSpread; spread < 1; spread *= 1.013f) {
    // Half a step is a tenth of an octave; the rough logarithm is wrong by 0.01 octaves at the most, and 5 steps an
    // octave make a twentieth of a step of that.
    EXPECT_NEAR(std::log2(sweptHalfSpreadOf(sweptCode(0.5f, spread)) / spread), 0, 0.1 + 0.01);
  }
  EXPECT_EQ(sweptHalfSpreadOf(sweptCode(0.5f, kMinSpread / 2)), 0);
  EXPECT_EQ(sweptHalfSpreadOf(sweptCode(0.5f, 0)), 0);
}

TEST(SweptCode, IsNeverThatOfNothing) {
  EXPECT_NE(sweptCode(1, 1e9f), kNothingSwept);
  EXPECT_NE(sweptCode(1, 1), kNothingSwept);
}

TEST(SweptCode, LogarithmIsRightToAHundredth) {
  for (float x = 1e-6f; x < 1e6f; x *= 1.001f) {
    ASSERT_NEAR(roughLog2(x), std::log2(x), 0.01);
  }
}

}  // namespace
}  // namespace ocelli
