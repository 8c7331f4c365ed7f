#include "oc_core/camera/distortion_map.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

// d_f = 8 pixels to the right and 4 down, from z_n = 4 to z_f = 12.
constexpr DistortionSample kSample{{8, 4}, 1 / 4.0f, 1 / 12.0f};

TEST(DistortionSample, displacesByEquation33) {
  EXPECT_EQ(kSample.at(1 / 2.0f), glm::vec2(0)) << "nearer than z_n";
  EXPECT_EQ(kSample.at(1 / 4.0f), glm::vec2(0)) << "at z_n";
  // Half way in 1/z between 1/4 and 1/12 is 1/6.
  EXPECT_NEAR(kSample.at(1 / 6.0f).x, 4, 1e-5f);
  EXPECT_NEAR(kSample.at(1 / 6.0f).y, 2, 1e-5f);
  // (1/4 - 1/5) / (1/4 - 1/12) = 0.3
  EXPECT_NEAR(kSample.at(1 / 5.0f).x, 2.4f, 1e-5f);
  EXPECT_EQ(kSample.at(1 / 12.0f), glm::vec2(8, 4)) << "at z_f";
  EXPECT_EQ(kSample.at(1 / 100.0f), glm::vec2(8, 4)) << "beyond z_f";
  EXPECT_EQ(kSample.at(0), glm::vec2(8, 4)) << "at infinity";
}

TEST(DistortionSample, emptyIntervalDisplacesNothing) {
  EXPECT_EQ((DistortionSample{{8, 4}, 0.25f, 0.25f}.at(0.1f)), glm::vec2(0));
  EXPECT_EQ((DistortionSample{}.at(0.1f)), glm::vec2(0));
}

/// Sample (x, y) displaces by (x, 10 y), between 1/z = 1 + x and y / 10.
DistortionMap ramp(DistortionMap::Lookup lookup) {
  DistortionMap map(4, 3, lookup);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const auto fx = static_cast<float>(x);
      const auto fy = static_cast<float>(y);
      map.samples()(x, y) = {{fx, 10 * fy}, 1 + fx, fy / 10};
    }
  }
  return map;
}

TEST(DistortionMap, nearestLookupTakesTheSampleOfThePixel) {
  const DistortionMap map = ramp(DistortionMap::Lookup::kNearest);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      for (const float inside : {0.01f, 0.5f, 0.99f}) {
        const DistortionSample s = map.at(static_cast<float>(x) + inside, static_cast<float>(y) + 1 - inside);
        EXPECT_EQ(s.displacement, glm::vec2(x, 10 * y));
        EXPECT_EQ(s.inverseNear, 1 + static_cast<float>(x));
      }
    }
  }
}

TEST(DistortionMap, bilinearLookupReproducesALinearField) {
  const DistortionMap map = ramp(DistortionMap::Lookup::kBilinear);
  for (float v = 0.5f; v <= 2.5f; v += 0.125f) {
    for (float u = 0.5f; u <= 3.5f; u += 0.125f) {
      const DistortionSample s = map.at(u, v);
      EXPECT_NEAR(s.displacement.x, u - 0.5f, 1e-5f);
      EXPECT_NEAR(s.displacement.y, 10 * (v - 0.5f), 1e-5f);
      EXPECT_NEAR(s.inverseNear, u + 0.5f, 1e-5f);
      EXPECT_NEAR(s.inverseFar, (v - 0.5f) / 10, 1e-5f);
    }
  }
}

TEST(DistortionMap, beyondTheBordersTheNearestSampleInsideHolds) {
  for (const auto lookup : {DistortionMap::Lookup::kNearest, DistortionMap::Lookup::kBilinear}) {
    const DistortionMap map = ramp(lookup);
    EXPECT_EQ(map.at(-1e30f, 1.5f).displacement, glm::vec2(0, 10));
    EXPECT_EQ(map.at(1e30f, 1.5f).displacement, glm::vec2(3, 10));
    EXPECT_EQ(map.at(1.5f, -7).displacement, glm::vec2(1, 0));
    EXPECT_EQ(map.at(1.5f, 7).displacement, glm::vec2(1, 20));
  }
}

TEST(DistortionMap, longestDisplacementIsALength) {
  DistortionMap map(2, 2, DistortionMap::Lookup::kNearest);
  EXPECT_EQ(map.longestDisplacement(), 0);
  map.samples()(0, 1).displacement = {-3, 4};
  map.samples()(1, 1).displacement = {4.5f, 0};
  EXPECT_FLOAT_EQ(map.longestDisplacement(), 5);
}

}  // namespace
}  // namespace ocelli
