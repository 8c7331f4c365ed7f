#include "study/agent/picture_perspective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

glm::dmat2 turned(double radians, double pixelsPerMeter) {
  const double c = std::cos(radians) * pixelsPerMeter;
  const double s = std::sin(radians) * pixelsPerMeter;
  return {{c, s}, {-s, c}};
}

/// Floor and walls of a box, seen so that heights go up in the picture.
PerspectiveFit seenBy(const glm::dmat2& map, double pixelsPerMeterOfHeight) {
  PerspectiveFit fit;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 point(4 + i * 0.5, k * 0.3, -7 + j * 0.5);
        const glm::dvec2 pixel =
            map * glm::dvec2(point.x, point.z) + glm::dvec2(300, 200 - pixelsPerMeterOfHeight * point.y);
        fit.add(pixel, point);
      }
    }
  }
  return fit;
}

TEST(PicturePerspective, fitsScaleAndTurnWhateverTheHeights) {
  for (const double turn : {0.0, 0.7, 2.9, -1.6}) {
    const auto perspective = seenBy(turned(turn, 12), 9).result();
    ASSERT_TRUE(perspective.has_value());
    // The ridge shrinks the map by the millionth part of the spread of all three coordinates.
    EXPECT_NEAR(perspective->pixelsPerMeter(), 12, 1e-4);
    EXPECT_NEAR(std::remainder(perspective->turnRadians() - turn, 2 * kPi), 0, 1e-5);
  }
}

TEST(PicturePerspective, turnsAreClockwiseFromNorthAtTheTop) {
  // East points down: the picture is turned by a quarter, clockwise.
  EXPECT_NEAR((PicturePerspective{{{0, 1}, {-1, 0}}}.turnRadians()), kPi / 2, 1e-12);
  EXPECT_NEAR(turnBetween({turned(3, 1)}, {turned(-3, 1)}), 2 * kPi - 6, 1e-12);
}

TEST(PicturePerspective, placesAreOffByWhatPixelsAreInMeters) {
  // 20 pixels a metre across, 4 along the line of sight.
  const PicturePerspective perspective{{{20, 0}, {0, 4}}};
  EXPECT_EQ(perspective.metersFrom({10, 10}), glm::dvec2(0.5, 2.5));
  const glm::dmat2 covariance = perspective.placeCovariance(10);
  EXPECT_DOUBLE_EQ(covariance[0][0], 0.25);
  EXPECT_DOUBLE_EQ(covariance[1][1], 6.25);
  EXPECT_DOUBLE_EQ(covariance[0][1], 0);
}

TEST(PicturePerspective, whatTellsNoPlacesHasNone) {
  PerspectiveFit few;
  few.add({0, 0}, {0, 0, 0});
  few.add({1, 0}, {1, 0, 0});
  few.add({0, 1}, {0, 0, 1});
  EXPECT_FALSE(few.result().has_value());
  PerspectiveFit line;
  PerspectiveFit point;
  for (int i = 0; i < 10; ++i) {
    line.add({i, 2 * i}, {i, 0, 3 * i});
    point.add({i, 0}, {5, 1, 5});
  }
  EXPECT_FALSE(line.result().has_value());
  EXPECT_FALSE(point.result().has_value());
}

TEST(PicturePerspective, isNeverFlatterThanOneToFifty) {
  const auto perspective = seenBy({{40, 0}, {0, 1e-3}}, 30).result();
  ASSERT_TRUE(perspective.has_value());
  EXPECT_NEAR(perspective->pixelsFromMeters[0][0], 40, 1e-3);
  EXPECT_NEAR(perspective->pixelsFromMeters[1][1], 40.0 / 50, 1e-3);
  EXPECT_NEAR(perspective->turnRadians(), 0, 1e-3);
}

}  // namespace
}  // namespace ocelli
