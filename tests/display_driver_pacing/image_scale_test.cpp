#include "display_driver/pacing/image_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

/// What a stage takes that has a part which depends on the pixels.
double seconds(double scale, double fixed, double whole) {
  return fixed + whole * scale * scale;
}

TEST(ImageScale, StaysWhereTimeSuffices) {
  ImageScale scale(0.03, 0.25);
  for (int i = 0; i < 100; ++i) {
    scale.add(scale.next(), seconds(scale.next(), 0.005, 0.02));
    EXPECT_EQ(scale.next(), 1);
  }
}

TEST(ImageScale, FindsTheLargestThatIsInTime) {
  for (const double whole : {0.04, 0.1, 0.3}) {
    ImageScale scale(0.03, 0.1);
    int late = 0;
    for (int i = 0; i < 200; ++i) {
      const double took = seconds(scale.next(), 0.005, whole);
      late += took > 0.03 ? 1 : 0;
      scale.add(scale.next(), took);
    }
    EXPECT_LE(late, 5) << whole;
    const double largest = std::sqrt(0.025 / whole);
    EXPECT_LE(scale.next(), largest);
    EXPECT_GE(scale.next(), largest * 0.7) << whole;
  }
}

TEST(ImageScale, NeverBelowTheLeast) {
  ImageScale scale(0.03, 0.4);
  for (int i = 0; i < 50; ++i) {
    scale.add(scale.next(), 1);
    EXPECT_GE(scale.next(), 0.4);
  }
  EXPECT_EQ(scale.next(), 0.4);
  ImageScale fixed(0.03, 1);
  fixed.add(1, 1);
  EXPECT_EQ(fixed.next(), 1);
}

TEST(ImageScale, AHiccupCostsOneStep) {
  ImageScale scale(0.03, 0.25);
  for (int hiccup = 0; hiccup < 3; ++hiccup) {
    scale.add(1, 0.3);
    EXPECT_NEAR(scale.next(), std::pow(0.5, 0.25), 1e-9) << "a quarter of a halving";
    for (int i = 0; i < 10; ++i) {
      scale.add(scale.next(), 0.01);
    }
    EXPECT_EQ(scale.next(), 1);
  }
}

TEST(ImageScale, ComesBackAfterTimeWasShort) {
  ImageScale scale(0.03, 0.25);
  scale.add(1, 0.3);
  scale.add(1, 0.3);
  EXPECT_LT(scale.next(), 0.4);
  int until = 0;
  while (scale.next() < 1) {
    scale.add(scale.next(), seconds(scale.next(), 0.002, 0.02));
    ASSERT_LT(++until, 100);
  }
}

TEST(ImageScale, AnImageThatWasUnderWayMeanwhileDoesNotCountTwice) {
  ImageScale scale(0.03, 0.1);
  scale.add(1, 0.06);
  scale.add(1, 0.06);
  const double once = scale.next();
  scale.add(1, 0.06);
  EXPECT_EQ(scale.next(), once);
}

}  // namespace
}  // namespace ocelli
