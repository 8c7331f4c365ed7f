#include "oc_core/image/image_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

Image<Rgb8> plain(const Rgb8& color) {
  return {5, 4, color};
}

TEST(MeanSquaredError, hasItsAnalyticValues) {
  EXPECT_EQ(meanSquaredError(plain({0, 0, 0}), plain({255, 255, 255})), 1);
  EXPECT_EQ(meanSquaredError(plain({7, 7, 7}), plain({7, 7, 7})), 0);
  Image<Rgb8> one(2, 2, Rgb8(10, 20, 30));
  const Image<Rgb8> other = one;
  one(1, 0).y = 25;  // 5 levels in one of twelve values
  EXPECT_DOUBLE_EQ(meanSquaredError(one, other), 25.0 / (12 * 255.0 * 255.0));
  EXPECT_DOUBLE_EQ(meanSquaredError(other, one), 25.0 / (12 * 255.0 * 255.0));
}

TEST(Psnr, hasItsAnalyticValues) {
  EXPECT_DOUBLE_EQ(psnrDecibels(1), 0);
  EXPECT_DOUBLE_EQ(psnrDecibels(0.01), 20);
  EXPECT_TRUE(std::isinf(psnrDecibels(0)));
  // Every value one level off: 20 log10(255).
  EXPECT_NEAR(psnrDecibels(meanSquaredError(plain({4, 4, 4}), plain({5, 5, 5}))), 48.1308, 1e-4);
}

}  // namespace
}  // namespace ocelli
