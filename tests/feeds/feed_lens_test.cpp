#include "oc_core/feeds/feed_lens.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(FeedLens, withoutDistortionIsAPinhole) {
  const FeedLens lens{{500, 400}, {320, 240}};
  const auto pixel = pixelOf(lens, {0.1, -0.2});
  ASSERT_TRUE(pixel);
  EXPECT_DOUBLE_EQ(pixel->x, 370);
  EXPECT_DOUBLE_EQ(pixel->y, 160);
}

TEST(FeedLens, distortsAsWrittenInItsHeader) {
  const FeedLens lens{{1, 1}, {0, 0}, 0.1, 0, 0, 0, 0};
  EXPECT_NEAR(pixelOf(lens, {0.5, 0})->x, 0.5 * (1 + 0.1 * 0.25), 1e-15);
  const FeedLens tangential{{1, 1}, {0, 0}, 0, 0, 0.01, 0.02, 0};
  const auto pixel = pixelOf(tangential, {0.3, 0.4});
  EXPECT_NEAR(pixel->x, 0.3 + 2 * 0.01 * 0.12 + 0.02 * (0.25 + 0.18), 1e-15);
  EXPECT_NEAR(pixel->y, 0.4 + 0.01 * (0.25 + 0.32) + 2 * 0.02 * 0.12, 1e-15);
}

TEST(FeedLens, directionUndoesPixel) {
  const FeedLens lens{{520, 530}, {322, 236}, -0.25, 0.08, 1e-3, -2e-3, -0.01};
  for (double x = -0.6; x <= 0.6; x += 0.1) {
    for (double y = -0.45; y <= 0.45; y += 0.1) {
      const auto back = directionOf(lens, *pixelOf(lens, {x, y}));
      ASSERT_TRUE(back);
      // Newton's steps end below 1e-10.
      EXPECT_NEAR(back->x, x, 1e-9);
      EXPECT_NEAR(back->y, y, 1e-9);
    }
  }
}

TEST(FeedLens, saysNothingWhereThePolynomialTurnsBack) {
  const FeedLens lens{{500, 500}, {320, 240}, -0.3, 0, 0, 0, 0};
  EXPECT_TRUE(pixelOf(lens, {1.0, 0}));
  EXPECT_FALSE(pixelOf(lens, {1.1, 0}));  // r - 0.3 r^3 has its maximum at r = 1.054
}

}  // namespace
}  // namespace ocelli
