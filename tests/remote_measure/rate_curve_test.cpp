#include "oc_core/remote_measure/rate_curve.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(RateCurve, isAStraightLineOfLogarithms) {
  const std::vector<RatePoint> curve{{10, 16000, 0.01}, {20, 4000, 0.04}, {30, 1000, 0.16}};
  EXPECT_DOUBLE_EQ(*bytesAtFlip(curve, 0.04), 4000);
  // Half of the way, by the logarithm, from 0.01 to 0.04.
  EXPECT_NEAR(*bytesAtFlip(curve, 0.02), 8000, 1e-6);
  EXPECT_NEAR(*bytesAtFlip(curve, 0.08), 2000, 1e-6);
  EXPECT_DOUBLE_EQ(*bytesAtFlip(curve, 0.01), 16000);
  EXPECT_DOUBLE_EQ(*bytesAtFlip(curve, 0.16), 1000);
}

TEST(RateCurve, saysNothingBeyondItsEnds) {
  const std::vector<RatePoint> curve{{10, 16000, 0.01}, {20, 4000, 0.04}};
  EXPECT_FALSE(bytesAtFlip(curve, 0.009));
  EXPECT_FALSE(bytesAtFlip(curve, 0.041));
  EXPECT_FALSE(bytesAtFlip({{10, 16000, 0.01}}, 0.01));
  EXPECT_FALSE(bytesAtFlip({}, 0.01));
}

}  // namespace
}  // namespace ocelli
