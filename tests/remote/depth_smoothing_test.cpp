#include "oc_core/remote/depth_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

/// A slope of `perPixel` levels a pixel from 100 on.
double slopeAt(int x, int y, double perPixel) {
  return 100 + perPixel * x + 0.5 * perPixel * y;
}

Image<uint16_t> roundedSlope(int width, int height, double perPixel) {
  Image<uint16_t> values(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      values(x, y) = static_cast<uint16_t>(std::lround(slopeAt(x, y, perPixel)));
    }
  }
  return values;
}

double meanError(const Image<float>& levels, double perPixel) {
  double sum = 0;
  for (int y = 0; y < levels.height(); ++y) {
    for (int x = 0; x < levels.width(); ++x) {
      sum += std::abs(static_cast<double>(levels(x, y)) - slopeAt(x, y, perPixel));
    }
  }
  return sum / static_cast<double>(levels.size());
}

TEST(DepthSmoothing, BringsSlopesBack) {
  for (const double perPixel : {0.13, 0.4, 2.3}) {
    const Image<uint16_t> values = roundedSlope(60, 50, perPixel);
    Image<float> rounded(60, 50);
    std::copy(values.begin(), values.end(), rounded.begin());
    EXPECT_LT(meanError(smoothedLevels(values), perPixel), 0.7 * meanError(rounded, perPixel)) << perPixel;
  }
}

TEST(DepthSmoothing, TurnsAStepIntoSmallOnes) {
  // A step every eight pixels: rounding says 0 or 1 from a pixel to the next, the slope is an eighth.
  const Image<float> levels = smoothedLevels(roundedSlope(64, 3, 0.125));
  for (int x = 10; x < 54; ++x) {
    EXPECT_LT(std::abs(levels(x, 1) - levels(x - 1, 1)), 0.35f);
  }
}

TEST(DepthSmoothing, StaysWithinHalfALevelAndLeavesEdgesAlone) {
  Image<uint16_t> values = roundedSlope(40, 30, 0.3);
  for (int y = 0; y < 30; ++y) {
    for (int x = 20; x < 40; ++x) {
      values(x, y) = static_cast<uint16_t>(values(x, y) + 50);  // an edge
    }
    values(35, y) = 0;  // nothing
  }
  const Image<float> levels = smoothedLevels(values);
  for (size_t i = 0; i < levels.size(); ++i) {
    EXPECT_LE(std::abs(levels[i] - static_cast<float>(values[i])), 0.5f);
    EXPECT_EQ(levels[i] == 0, values[i] == 0);
  }
  for (int y = 0; y < 30; ++y) {
    EXPECT_GT(levels(20, y) - levels(19, y), 49);
  }
}

TEST(DepthSmoothing, SmallestImages) {
  EXPECT_EQ(smoothedLevels(Image<uint16_t>()).size(), 0u);
  EXPECT_EQ(smoothedLevels(Image<uint16_t>(1, 1, 7))[0], 7);
  EXPECT_EQ(smoothedLevels(Image<uint16_t>(2, 1, 7)), Image<float>(2, 1, 7.0f));
}

}  // namespace
}  // namespace ocelli
