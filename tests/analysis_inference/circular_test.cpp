#include "analysis/inference/circular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::vector<double> radians(std::vector<double> degrees) {
  for (double& each : degrees) {
    each *= kDegree;
  }
  return degrees;
}

// Zar 2010, Biostatistical Analysis, 5th edition: leaning trees of examples 26.4 and 27.1, and vertebrates of 27.2.
const std::vector<double> kTrees = radians({45, 55, 81, 96, 110, 117, 132, 154});
const std::vector<double> kReleased = radians({66, 75, 86, 88, 88, 93, 97, 101, 118, 130});

TEST(Circular, IsWhatZarHas) {
  const MeanVector trees = meanVector(kTrees);
  EXPECT_NEAR(trees.length(), 0.82522, 5e-6);
  EXPECT_NEAR(trees.direction() / kDegree, 99, 0.5) << "whole degrees in the book";
  const Estimate rayleigh = *rayleighTest(kTrees);
  EXPECT_NEAR(rayleigh.statistic, 5.448, 5e-4);
  EXPECT_GT(rayleigh.pValue, 0.001);
  EXPECT_LT(rayleigh.pValue, 0.002);
  const Estimate towardsEast = *vTest(kReleased, 90 * kDegree);
  EXPECT_NEAR(towardsEast.value * 10, 9.498, 5e-4);
  EXPECT_NEAR(towardsEast.statistic, 4.248, 1e-3);
  EXPECT_LT(towardsEast.pValue, 0.0005);
}

TEST(Circular, DeviationIsThatOfFisher) {
  EXPECT_DOUBLE_EQ(circularDeviation(1), 0);
  EXPECT_NEAR(circularDeviation(std::exp(-0.5)), 1, 1e-15);
  EXPECT_TRUE(std::isinf(circularDeviation(0)));
}

constexpr int kUniformSamples = 40000;

/// The share of samples of uniform directions whose statistic is at least that of a sample with p value `p`: a
/// reference by simulation, with standard errors of 0.001 at p = 0.05.
template <class Test>
void expectLevel(int n, double p, double tolerance, const Test& test) {
  RandomNumbers numbers(static_cast<uint64_t>(n));
  int rejected = 0;

  for (int i = 0; i < kUniformSamples; ++i) {
    std::vector<double> angles;
    for (int k = 0; k < n; ++k) {
      angles.push_back(2 * std::numbers::pi * numbers.uniform());
    }
    rejected += test(angles) <= p ? 1 : 0;
  }
  EXPECT_NEAR(rejected / static_cast<double>(kUniformSamples), p, tolerance) << n << " directions";
}

TEST(Circular, TestsHoldTheirLevel) {
  for (const int n : {5, 8, 24}) {
    for (const double p : {0.01, 0.05}) {
      // Five standard errors of the simulation, and 0.002 of the approximation, as the header says.
      const double tolerance = 5 * std::sqrt(p * (1 - p) / kUniformSamples) + 0.002;
      expectLevel(n, p, tolerance, [](const auto& angles) { return rayleighTest(angles)->pValue; });
      expectLevel(n, p, tolerance, [](const auto& angles) { return vTest(angles, 1)->pValue; });
    }
  }
}

std::vector<MeanVector> vectorsAround(RandomNumbers& numbers, int n, double direction, double length) {
  std::vector<MeanVector> vectors;
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  for (int i = 0; i < n; ++i) {
    const double along = length + 0.15 * numbers.normal();
    const double across = 0.2 * numbers.normal() + 0.3 * (along - length);
    vectors.push_back({along * c - across * s, along * s + across * c});
  }
  return vectors;
}

/// The intervals of Fieller are exact for normal vectors: of 4000, 95 % hold the truth, within five standard errors.
TEST(Circular, IntervalsHoldTheTruth) {
  RandomNumbers numbers(7);
  constexpr int kSamples = 4000;
  constexpr double kTruth = 3;  // near pi, where directions wrap
  int directions = 0;
  int lengths = 0;
  int turns = 0;
  int equal = 0;
  for (int i = 0; i < kSamples; ++i) {
    const std::vector<MeanVector> first = vectorsAround(numbers, 12, kTruth, 0.7);
    const std::vector<MeanVector> second = vectorsAround(numbers, 12, kTruth + 0.4, 0.6);
    const CircularMean mean = *circularMean(first);
    const double off = std::remainder(kTruth - mean.direction->value, 2 * std::numbers::pi) + mean.direction->value;
    directions += mean.direction->lower <= off && off <= mean.direction->upper ? 1 : 0;
    lengths += mean.length->lower <= 0.7 && 0.7 <= mean.length->upper ? 1 : 0;
    const Estimate turn = *directionDifference(first, second);
    turns += turn.lower <= 0.4 && 0.4 <= turn.upper ? 1 : 0;
    equal += hotellingDifference(first, vectorsAround(numbers, 12, kTruth, 0.7))->pValue > 0.05 ? 1 : 0;
  }
  const double tolerance = 5 * std::sqrt(0.95 * 0.05 / kSamples);
  EXPECT_NEAR(directions / 4000.0, 0.95, tolerance);
  EXPECT_NEAR(equal / 4000.0, 0.95, tolerance) << "Hotelling's test is exact too";
  // Linearised, so that 1 % more is allowed for.
  EXPECT_NEAR(lengths / 4000.0, 0.95, tolerance + 0.01);
  EXPECT_NEAR(turns / 4000.0, 0.95, tolerance + 0.01);
}

TEST(Circular, HotellingByHand) {
  const std::vector<MeanVector> zero(4);
  // Differences (1, 0), (3, 0), (2, 1), (2, -1): mean (2, 0), variances 2/3 and 2/3, no covariance. T2 = 4 * 4 / (2/3)
  // = 24, F = 24 * 2 / 6 = 8 of 2 and 2 degrees of freedom, whose tail is 1 / (1 + 8).
  const Estimate test = *hotellingDifference(zero, {{1, 0}, {3, 0}, {2, 1}, {2, -1}});
  EXPECT_NEAR(test.statistic, 8, 1e-12);
  EXPECT_NEAR(test.pValue, 1.0 / 9, 1e-12);
  EXPECT_EQ(test.value, 2);
}

TEST(Circular, SaysWhatItLacks) {
  EXPECT_EQ(rayleighTest({1, 2}).reason(), "there are 2 directions, and 5 are needed");
  EXPECT_EQ(circularMean({{1, 0}}).reason(), "there are 1 subjects, and 3 are needed");
  EXPECT_FALSE(circularMean({{1, 0}, {1, 0}, {1, 0}})) << "all alike";
  const std::vector<MeanVector> apart{{1, 0}, {-1, 0.1}, {0, 1}, {0.1, -1}};
  EXPECT_FALSE(circularMean(apart)->direction) << "any direction may be the mean";
  EXPECT_TRUE(circularMean(apart)->length);
  EXPECT_FALSE(directionDifference(apart, apart));
  EXPECT_FALSE(hotellingDifference(apart, apart)) << "no spread";
  EXPECT_THROW(meanVector(std::vector<double>{}), InputError);
  EXPECT_THROW(hotellingDifference(apart, {}), InputError);
}

}  // namespace
}  // namespace ocelli::test
