#include "display_driver/pacing/image_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

/// What making takes that has a part which depends on the pixels.
double seconds(double scale, double fixed, double whole) {
  return fixed + whole * scale * scale;
}

/// One that has grown to its full size.
ImageScale grown(double seconds, double minScale) {
  ImageScale scale(seconds, minScale);
  while (scale.next() < 1) {
    scale.add(scale.next(), 0);
  }
  // The first late one ends that, and takes back the last step.
  scale.add(1, seconds * 1.01);
  while (minScale < 1 && scale.next() < 1) {
    scale.add(scale.next(), 0);
  }
  return scale;
}

TEST(ImageScale, BeginsSmallAndGrowsWithEachImage) {
  ImageScale scale(0.03, 0.25);
  EXPECT_EQ(scale.next(), 0.25);
  // Eight steps of the fourth root of 1/2.
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT(scale.next(), 1) << i;
    scale.add(scale.next(), seconds(scale.next(), 0.005, 0.015));
  }
  EXPECT_EQ(scale.next(), 1);
}

TEST(ImageScale, StaysWhereTimeSuffices) {
  ImageScale scale = grown(0.03, 0.25);
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
    // Time is known to grow with the pixels at its worst, so none that is larger than it may be is tried.
    EXPECT_EQ(late, 0) << whole;
    const double largest = std::sqrt(0.025 / whole);
    EXPECT_LE(scale.next(), largest);
    EXPECT_GE(scale.next(), largest * 0.7) << whole;
  }
}

TEST(ImageScale, NeverBelowTheLeast) {
  ImageScale scale = grown(0.03, 0.4);
  for (int i = 0; i < 50; ++i) {
    scale.add(scale.next(), 1);
    EXPECT_GE(scale.next(), 0.4);
  }
  EXPECT_EQ(scale.next(), 0.4);
  ImageScale fixed(0.03, 1);
  EXPECT_EQ(fixed.next(), 1);
  fixed.add(1, 1);
  EXPECT_EQ(fixed.next(), 1);
}

TEST(ImageScale, AHiccupCostsNothing) {
  ImageScale scale = grown(0.03, 0.25);
  for (int hiccup = 0; hiccup < 3; ++hiccup) {
    for (int i = 0; i < 10; ++i) {
      scale.add(scale.next(), 0.01);
    }
    scale.add(1, 0.3);
    EXPECT_EQ(scale.next(), 1);
  }
}

/// Times that now and then are half as long again: the scale must not go up and down with them.
TEST(ImageScale, KeepsAScaleWhoseTimesVary) {
  ImageScale scale(0.03, 0.1);
  int late = 0;
  int changes = 0;
  for (int i = 0; i < 2000; ++i) {
    const double used = scale.next();
    const double took = seconds(used, 0.008, 0.08) * (i % 9 == 0 ? 1.5 : 1);
    late += took > 0.03 ? 1 : 0;
    scale.add(used, took);
    changes += scale.next() != used && i > 200 ? 1 : 0;
  }
  EXPECT_LE(late, 2000 / 9) << "none but those that take half as long again";
  EXPECT_LE(changes, 20);
  // 0.03 s are reached at 0.52.
  EXPECT_GE(scale.next(), 0.35);
  EXPECT_LE(scale.next(), 0.53);
}

TEST(ImageScale, ComesBackAfterTimeWasShort) {
  ImageScale scale = grown(0.03, 0.25);
  scale.add(1, 0.3);
  scale.add(1, 0.3);
  EXPECT_LT(scale.next(), 0.4);
  int until = 0;
  while (scale.next() < 1) {
    scale.add(scale.next(), seconds(scale.next(), 0.002, 0.02));
    ASSERT_LT(++until, 1000);
  }
  EXPECT_GT(until, 6 * 4) << "six images a step, and more than four steps";
}

TEST(ImageScale, AnImageThatWasUnderWayMeanwhileDoesNotCountTwice) {
  ImageScale scale = grown(0.03, 0.1);
  scale.add(1, 0.06);
  scale.add(1, 0.06);
  const double once = scale.next();
  scale.add(1, 0.06);
  EXPECT_EQ(scale.next(), once);
}

}  // namespace
}  // namespace ocelli
