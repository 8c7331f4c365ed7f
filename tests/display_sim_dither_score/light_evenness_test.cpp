#include "display_sim/dither_score/light_evenness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

// A display of the reference's proportions, at a third of its size: 8 rows and columns of counted light a sample.
DisplayProfile thirdOfTheReference() {
  return test::smallProfile(66, 256, 256);
}

const LightSample& nearestTo(const std::vector<LightSample>& samples, TestSurface surface, double radius) {
  const LightSample* found = nullptr;
  for (const LightSample& sample : samples) {
    if (sample.surface == surface &&
        (found == nullptr || std::abs(sample.radius - radius) < std::abs(found->radius - radius))) {
      found = &sample;
    }
  }
  return *found;
}

// White, so every cell counts, and those of a floor, a cylinder in the middle of columns and a fin within a sector are
// as many as the formula says. A wall has in every row a cell for each of a bin's 5 columns and one for each border of
// sectors that it crosses there, which is a whole number: it strays by less than one in five.
TEST(LightEvenness, withoutWeightsIsWhatTheFormulaSays) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    DisplayProfile profile = thirdOfTheReference();
    profile.secondHalfTurn = half;
    for (const LightSample& sample : measureEvenness(profile, {})) {
      const double tolerance = sample.surface == TestSurface::kWall ? 0.2 : 1e-3;
      EXPECT_NEAR(sample.lightPerArea / sample.expected, 1, tolerance) << nameOf(sample.surface) << sample.radius;
    }
  }
}

TEST(LightEvenness, evenLightIsEvenForCylindersNearAndFar) {
  const std::vector<LightSample> plain = measureEvenness(thirdOfTheReference(), {});
  const std::vector<LightSample> even = measureEvenness(thirdOfTheReference(), {.evenLightRadius = 1});
  const auto ratio = [](const std::vector<LightSample>& samples) {
    return nearestTo(samples, TestSurface::kCylinder, 0.2).lightPerArea /
           nearestTo(samples, TestSurface::kCylinder, 0.9).lightPerArea;
  };
  const double predicted =
      nearestTo(plain, TestSurface::kCylinder, 0.9).radius / nearestTo(plain, TestSurface::kCylinder, 0.2).radius;
  EXPECT_NEAR(ratio(plain), predicted, 0.01 * predicted);
  // Each is the mean of some 17,000 dithered voxels, and dithering errs by less than 1 / 100 of full light over as many
  // (ditheringKeepsTheMeanColor); the near one has a light of 0.2, so by less than 5 %.
  EXPECT_NEAR(ratio(even), 1, 0.05);
}

TEST(LightEvenness, evenLightIsTheSameForAllSurfacesAtTheCostOfLight) {
  for (const double radius : {0.5, 1.0}) {
    const std::vector<LightSample> plain = measureEvenness(thirdOfTheReference(), {});
    const std::vector<LightSample> even = measureEvenness(thirdOfTheReference(), {.evenLightRadius = radius});
    // 1 / r from 1/48 to the radius: 24 and 48, without.
    EXPECT_GT(scoreEvenness(plain, radius).largestOverLeast, 10);
    // Walls are the worst, for the reason above.
    EXPECT_LT(scoreEvenness(even, radius).largestOverLeast, 1.4);
    EXPECT_LT(scoreEvenness(even, radius).relativeDeviation, 0.05);
    EXPECT_NEAR(scoreEvenness(even, radius).mean, 1 / radius, 0.02 / radius);
  }
}

TEST(LightEvenness, scoresKnownLights) {
  std::vector<LightSample> samples(4);
  for (size_t i = 0; i < 4; ++i) {
    samples[i].radius = 0.2 * static_cast<double>(i + 1);
    samples[i].lightPerArea = i < 2 ? 1 : 3;
  }
  const EvennessScore all = scoreEvenness(samples);
  EXPECT_DOUBLE_EQ(all.largestOverLeast, 3);
  EXPECT_DOUBLE_EQ(all.mean, 2);
  EXPECT_DOUBLE_EQ(all.relativeDeviation, 0.5);
  EXPECT_DOUBLE_EQ(scoreEvenness(samples, 0.5).largestOverLeast, 1);
}

}  // namespace
}  // namespace ocelli
