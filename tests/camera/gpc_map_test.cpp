#include "oc_core/camera/gpc_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace ocelli {
namespace {

constexpr int kMapWidth = 800;
constexpr int kMapHeight = 480;

GpcMap textsMap(const char* sampling) {
  return {{findGpcSampling(sampling), {{{0.5f, 0.5f}, {0.5f, 0.5f}, 3, 1}}}, kMapWidth, kMapHeight};
}
GpcMap twoZones(const char* sampling) {
  return {{findGpcSampling(sampling), {{{0.25f, 0.5f}, {0.2f, 0.3f}, 4, 1}, {{0.8f, 0.3f}, {0.1f, 0.2f}, 2, 1}}},
          kMapWidth,
          kMapHeight};
}

// Equation 5.2, by hand on the middle row of its left region: W = 800, w = 400, zf = 3. u_l = 0, u_r = 200, and
// u_d(u_r) = 400 - 200 / 3.
TEST(GpcMap, quadraticOfTheText) {
  const GpcMap map = textsMap("quadratic");
  EXPECT_NEAR(map.pinholeFromImage({0, 240}).x, 0, 1e-9);
  EXPECT_NEAR(map.pinholeFromImage({200, 240}).x, 400 - 200.0 / 3, 1e-9);
  // u_d = a0 u^2 + a1 u with a slope of 1/3 at u_r: a0 200 + a1 = 5/3 and 400 a0 + a1 = 1/3.
  const double a0 = (1.0 / 3 - 5.0 / 3) / 200;
  const double a1 = 5.0 / 3 - 200 * a0;
  EXPECT_NEAR(map.pinholeFromImage({77, 240}).x, a0 * 77 * 77 + a1 * 77, 1e-9);
  // "the sample be distorted on a line towards the center".
  const glm::dvec2 p = map.pinholeFromImage({77, 300});
  EXPECT_NEAR(p.x, a0 * 77 * 77 + a1 * 77, 1e-9);
  EXPECT_NEAR((p.y - 240) / (p.x - 400), (300.0 - 240) / (77 - 400), 1e-12);
  // Equation 5.3 is its inverse.
  EXPECT_NEAR(map.imageFromPinhole(p).x, 77, 1e-9);
  EXPECT_NEAR(map.imageFromPinhole(p).y, 300, 1e-9);
}

TEST(GpcMap, inverseOverTheImage) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  for (const GpcSampling& each : gpcSamplings()) {
    const GpcMap map = twoZones(each.name);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
      const glm::dvec2 image(kMapWidth * any(random), kMapHeight * any(random));
      worst = std::max(worst, glm::distance(map.imageFromPinhole(map.pinholeFromImage(image)), image));
    }
    EXPECT_LT(worst, 1e-9) << each.name;
  }
}

// A step of a millionth of a pixel anywhere moves the sample by no more than the greatest slope says: no jumps, at the
// edges and diagonals above all.
TEST(GpcMap, isContinuous) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(0, 1);
  for (const GpcSampling& each : gpcSamplings()) {
    const GpcMap map = twoZones(each.name);
    for (const GpcZone& zone : map.zones()) {
      const double longest = 1 / zone.profile().leastRate() * 4;  // and the shear of the widest rectangle here
      for (int i = 0; i < 20'000; ++i) {
        // On the inner edge, the outer edge and the diagonals.
        const double r = i % 3 == 0 ? 1 : i % 3 == 1 ? zone.profile().outer() : 1 + any(random);
        const double other = i % 3 == 2 ? r : r * (2 * any(random) - 1);
        const glm::dvec2 on = zone.center() + zone.half() * glm::dvec2(i % 2 == 0 ? r : other, i % 2 == 0 ? other : r);
        const double angle = 6.2832 * any(random);
        const glm::dvec2 step = 1e-6 * glm::dvec2(std::cos(angle), std::sin(angle));
        ASSERT_LT(glm::distance(map.pinholeFromImage(on + step), map.pinholeFromImage(on - step)), 2e-6 * longest)
            << each.name << " " << on.x << " " << on.y;
      }
    }
  }
}

TEST(GpcMap, jacobianIsThatOfDifferences) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(0, 1);
  constexpr double kStep = 1e-4;
  for (const GpcSampling& each : gpcSamplings()) {
    const GpcMap map = twoZones(each.name);
    int compared = 0;
    for (int i = 0; i < 5000; ++i) {
      const glm::dvec2 p(kMapWidth * any(random), kMapHeight * any(random));
      const GpcZone* zone = map.zoneAt(p);
      if (zone != nullptr) {  // not across an edge or a diagonal
        const glm::dvec2 d = glm::abs((p - zone->center()) / zone->half());
        const double r = std::max(d.x, d.y);
        if (std::abs(r - 1) < 1e-4 || std::abs(r - zone->profile().outer()) < 1e-4 || std::abs(d.x - d.y) < 1e-4) {
          continue;
        }
      }
      const glm::dmat2 m = map.jacobian(p);
      for (int axis = 0; axis < 2; ++axis) {
        glm::dvec2 step(0);
        step[axis] = kStep;
        const glm::dvec2 slope = (map.pinholeFromImage(p + step) - map.pinholeFromImage(p - step)) / (2 * kStep);
        ASSERT_LT(glm::distance(slope, m[axis]), 1e-5) << each.name << " " << p.x << " " << p.y;
      }
      ++compared;
    }
    EXPECT_GT(compared, 4000);
  }
}

TEST(GpcMap, ratesByHand) {
  const GpcMap map = textsMap("quadratic");
  EXPECT_NEAR(map.rateAt({400, 240}), 3, 1e-12);
  // On the axes nothing is sheared: the text's 0.333 at the border.
  EXPECT_NEAR(map.rateAt({1e-9, 240}), 1.0 / 3, 1e-9);
  EXPECT_NEAR(map.rateAt({400, 1e-9}), 1.0 / 3, 1e-9);
  // At a corner the shear comes in, and the rate is lower in some direction.
  EXPECT_LT(map.rateAt({1e-9, 2e-9}), 1.0 / 3);
  const glm::dvec2 both = singularValues(glm::dmat2(3, 0, 0, 2));
  EXPECT_DOUBLE_EQ(both.x, 3);
  EXPECT_DOUBLE_EQ(both.y, 2);
}

}  // namespace
}  // namespace ocelli
