#include "oc_core/camera/gpc_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ocelli {
namespace {

const GpcSampling& sampling(const char* name) {
  return *findGpcSampling(name);
}

// Section 5.2.1.2: w = W / 2, so the outer edge is twice as far out, and zf = 3.
TEST(GpcProfile, leastRatesOfTheText) {
  // "0.333 for this example", at the outer edge.
  EXPECT_NEAR(GpcProfile(sampling("quadratic"), 3, 2).leastRate(), 1.0 / 3, 1e-15);
  // The text prints 0.652 for a constant rate. f grows from 1/3 to 2 over a distance of 1: the rate is 3/5.
  EXPECT_NEAR(GpcProfile(sampling("linear"), 3, 2).leastRate(), 0.6, 1e-15);
  EXPECT_NEAR(highestLeastRate(3, 2), 0.6, 1e-15);
  // Figure 5.10: "minimum value here is 0.59". It is 18/30.5 where the outer edge is three times as far out.
  EXPECT_NEAR(GpcProfile(sampling("cubic"), 3, 3).leastRate(), 36.0 / 61, 1e-15);
  // By hand for the edges of the first example: f' = 1/3 + 20/3 t - 6 t^2, greatest at t = 5/9.
  EXPECT_NEAR(GpcProfile(sampling("cubic"), 3, 2).leastRate(), 27.0 / 59, 1e-15);
}

TEST(GpcProfile, noSamplingHasAHigherLeastRateThanTheLinearOne) {
  for (const double zoom : {1.5, 3.0, 20.0}) {
    for (const double outer : {1.1, 2.0, 9.0}) {
      for (const GpcSampling& each : gpcSamplings()) {
        EXPECT_LE(GpcProfile(each, zoom, outer).leastRate(), highestLeastRate(zoom, outer) * (1 + 1e-14)) << each.name;
      }
    }
  }
}

// The least rate and the longest shift against a million places.
TEST(GpcProfile, extremesAreExact) {
  for (const GpcSampling& each : gpcSamplings()) {
    for (const double zoom : {0.8, 1.0, 2.0, 7.0}) {
      const GpcProfile profile(each, zoom, 2.5);
      // At the edges, where the slope jumps, that of the transition.
      double greatest = std::max(profile.slope(1), profile.slope(2.5));
      double least = std::min(profile.slope(1), profile.slope(2.5));
      double shift = 0;
      constexpr int kPlaces = 100000;
      for (int i = 0; i <= kPlaces; ++i) {
        const double r = 3.0 * i / kPlaces;
        greatest = std::max(greatest, profile.slope(r));
        least = std::min(least, profile.slope(r));
        shift = std::max(shift, std::abs(r - profile.sampled(r)));
      }
      // The slope is a parabola: between two places it rises by less than its curvature times the square of a step.
      EXPECT_NEAR(1 / profile.leastRate(), greatest, 1e-8) << each.name << zoom;
      EXPECT_NEAR(1 / profile.greatestRate(), least, 1e-8) << each.name << zoom;
      EXPECT_NEAR(profile.longestShift(), shift, 1e-4) << each.name << zoom << ": the edge may lie between two places";
      EXPECT_GE(profile.longestShift(), shift - 1e-12);
    }
  }
}

TEST(GpcProfile, continuityAtTheEdges) {
  constexpr double kBeside = 1e-9;
  for (const GpcSampling& each : gpcSamplings()) {
    for (const double zoom : {1.5, 3.0, 20.0}) {
      const GpcProfile profile(each, zoom, 1.7);
      for (const double edge : {1.0, 1.7}) {
        EXPECT_NEAR(profile.sampled(edge - kBeside), profile.sampled(edge + kBeside), 1e-7) << each.name << zoom;
      }
      const double jumpInside = std::abs(profile.slope(1 - kBeside) - profile.slope(1 + kBeside));
      const double jumpOutside = std::abs(profile.slope(1.7 - kBeside) - profile.slope(1.7 + kBeside));
      const std::string name = each.name;
      EXPECT_EQ(jumpInside < 1e-6, name != "linear") << name << zoom;
      EXPECT_EQ(jumpOutside < 1e-6, name == "cubic") << name << zoom;
    }
  }
}

TEST(GpcProfile, inverseIsExact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const GpcSampling& each = gpcSamplings()[static_cast<size_t>(i) % gpcSamplings().size()];
    const double outer = 1.01 + 9 * any(random) * any(random);
    const GpcProfile profile(each, std::exp(4 * any(random)), outer);
    const double r = outer * 1.1 * any(random);
    // What f is off by for rounding is, over the slope, what r is off by.
    worst = std::max(worst, std::abs(profile.inverse(profile.sampled(r)) - r));
  }
  EXPECT_LT(worst, 1e-9);
}

// gpc_profile.h says when.
TEST(GpcProfile, foldsWhereItSays) {
  for (const double outer : {1.05, 1.5, 3.0, 10.0}) {
    for (const GpcSampling& each : gpcSamplings()) {
      for (const double zoom : {1.0, 1.5, 60.0}) {
        EXPECT_TRUE(GpcProfile(each, zoom, outer).isIncreasing()) << each.name << zoom << outer;
      }
    }
    const double linear = 1 / outer;
    const double quadratic = (outer + 1) / (2 * outer);
    for (const double beside : {-1e-6, 1e-6}) {
      EXPECT_EQ(GpcProfile(sampling("linear"), linear + beside, outer).isIncreasing(), beside > 0) << outer;
      EXPECT_EQ(GpcProfile(sampling("quadratic"), quadratic + beside, outer).isIncreasing(), beside > 0) << outer;
    }
    // The cubic against brute force: it folds where samples are not in order.
    for (double zoom = 0.1; zoom < 1; zoom += 0.01) {
      const GpcProfile profile(sampling("cubic"), zoom, outer);
      double least = 1e9;
      for (int i = 0; i <= 1000; ++i) {
        least = std::min(least, profile.slope(1 + (outer - 1) * i / 1000));
      }
      if (std::abs(least) > 1e-3) {
        EXPECT_EQ(profile.isIncreasing(), least > 0) << zoom << " " << outer;
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
