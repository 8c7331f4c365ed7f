#include "oc_core/drawing/color_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/plot/style.h"

namespace ocelli {
namespace {

constexpr int kSteps = 32;

double difference(const LabColor& a, const LabColor& b) {
  return std::hypot(a.lightness - b.lightness, a.a - b.a, a.b - b.b);
}

TEST(ColorScale, lightnessFallsInEqualSteps) {
  const double step = (labOf(scaleColor(0)).lightness - labOf(scaleColor(1)).lightness) / kSteps;
  EXPECT_GT(step * kSteps, 70);
  for (int i = 0; i < kSteps; ++i) {
    const double fall = labOf(scaleColor(i / static_cast<double>(kSteps))).lightness -
                        labOf(scaleColor((i + 1) / static_cast<double>(kSteps))).lightness;
    // Beyond the colours of a screen it would be cut off, and uneven.
    EXPECT_NEAR(fall, step, 0.02 * step) << i;
  }
}

TEST(ColorScale, equalStepsLookEqual) {
  double least = 1e9;
  double most = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double seen = difference(labOf(scaleColor(i / static_cast<double>(kSteps))),
                                   labOf(scaleColor((i + 1) / static_cast<double>(kSteps))));
    least = std::min(least, seen);
    most = std::max(most, seen);
  }
  EXPECT_LT(most, 1.7 * least);
}

/// WCAG 2.
double contrastOnWhite(const Paint& paint) {
  const double y = std::pow((labOf(paint).lightness + 16) / 116, 3);
  return 1.05 / (y + 0.05);
}

TEST(Style, seriesAndTextStandOutFromThePaper) {
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_GE(contrastOnWhite(seriesStyle(i).paint), 3) << i;  // of what is no text
  }
  EXPECT_GE(contrastOnWhite(kTextPaint), 4.5);
  EXPECT_GE(contrastOnWhite(kSoftTextPaint), 4.5);
}

TEST(Style, noTwoSeriesShareAMarkerOrADash) {
  for (size_t i = 0; i < 6; ++i) {
    for (size_t k = 0; k < i; ++k) {
      EXPECT_NE(seriesStyle(i).marker, seriesStyle(k).marker);
      EXPECT_NE(seriesStyle(i).dash, seriesStyle(k).dash);
    }
  }
}

}  // namespace
}  // namespace ocelli
