// Thin lines nearly along the axes (section 5.3.3.3): on a grid many samples change sides at once when they turn a
// little, which shows as flicker; samples with rows and columns of their own do so one by one.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/antialiasing/antialias_scenes.h"

namespace ocelli::test {
namespace {

/// Lines 0.3 pixels thick, six pixels apart, turned by an angle.
Mesh thinLines(const PinholeCamera& camera, double degrees) {
  Mesh mesh;
  const double turn = degrees * M_PI / 180;
  const glm::dvec2 along(std::cos(turn), std::sin(turn));
  const glm::dvec2 across(-along.y, along.x);
  for (int line = 0; line < 12; ++line) {
    const glm::dvec2 middle = glm::dvec2(36, 36) + across * (line * 6.03 - 33);
    const glm::vec2 a(middle - along * 80.0 - across * 0.15);
    const glm::vec2 b(middle + along * 80.0 - across * 0.15);
    const glm::vec2 c(middle + along * 80.0 + across * 0.15);
    const glm::vec2 d(middle - along * 80.0 + across * 0.15);
    addFlat(mesh, a, b, c, glm::vec3(1), camera);
    addFlat(mesh, a, c, d, glm::vec3(1), camera);
  }
  return mesh;
}

/// How far images are from exact areas over a small rotation, at its worst: RMSE.
double worstError(const PixelRule& rule, double fromDegrees) {
  const PinholeCamera camera = flatCamera(72, 72);
  double worst = 0;
  for (int step = 0; step < 10; ++step) {
    const Mesh mesh = thinLines(camera, fromDegrees + step * 0.03);
    const AntialiasScene scene(camera, mesh);
    worst = std::max(worst, rmse(scene.draw(everywhere(rule), glm::vec3(0)),
                                 scene.draw(everywhere(squareRule(1, "grid", 16)), glm::vec3(0))));
  }
  return worst;
}

TEST(ThinLines, rowsOfTheirOwnKeepLinesAlongTheAxesSteady) {
  for (const double from : {-0.15, 89.85}) {
    const double grid = worstError(squareRule(8, "grid"), from);
    // 8 rows give 8 shades, 64 rows give 64; jitter in each stratum is in between.
    EXPECT_LT(worstError(squareRule(8, "multijittered"), from), grid / 4);
    EXPECT_LT(worstError(squareRule(8, "jittered"), from), grid / 1.5);
  }
}

TEST(ThinLines, obliqueLinesCostLittle) {
  // A grid is good for a line whose slope is near no ratio of small numbers: it is what others give up for the axes.
  for (const char* placement : {"slanted", "multijittered"}) {
    EXPECT_LT(worstError(squareRule(8, placement), 20), worstError(squareRule(8, "grid"), 20) * 3) << placement;
  }
  EXPECT_GT(worstError(squareRule(8, "grid"), -0.15), worstError(squareRule(8, "grid"), 20) * 2);
}

}  // namespace
}  // namespace ocelli::test
