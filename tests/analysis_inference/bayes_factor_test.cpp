#include "analysis/inference/bayes_factor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/inference/crossed_clusters.h"
#include "analysis/inference/student.h"
#include "analysis/inference/wald.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

TEST(BayesFactor, OfTIsTheIntegralOfRouder) {
  const double medium = kMediumPriorScale;
  expectGolden(
      {bayesFactorOfT(0, 10).logForEffect, bayesFactorOfT(0.7, 45).logForEffect, bayesFactorOfT(2.5, 20).logForEffect,
       bayesFactorOfT(-2.5, 20, 1).logForEffect, bayesFactorOfT(8, 45).logForEffect,
       bayesFactorOfT(1.2, 2, medium).logForEffect, bayesFactorOfT(3, 2000).logForEffect},
      "bayes/t", 1e-9);  // of two quadratures
  std::vector<double> differences;
  for (size_t i = 0; i < golden("sample/first").size(); ++i) {
    differences.push_back(golden("sample/second")[i] - golden("sample/first")[i]);
  }
  expectGolden({bayesFactorOfMean(differences)->logForEffect}, "bayes/paired", 1e-9);
}

TEST(BayesFactor, HasTheValuesThatRouderPublished) {
  // Their example of 80 values with t = 2.03, with the scale 1 that they used then.
  EXPECT_NEAR(bayesFactorOfT(2.03, 80, 1).forNone, 1.56, 0.005);
}

TEST(BayesFactor, OfAnEstimateIsThatOfAMeanWithItsDegreesOfFreedom) {
  const std::vector<double> differences{0.1, -0.2, 0.3, 0.05, 0.2, 0.15};
  const BayesFactor ofMean = *bayesFactorOfMean(differences);
  const BayesFactor ofEstimate = *bayesFactorOfEstimate(*studentMean(differences));
  EXPECT_NEAR(ofEstimate.logForEffect, ofMean.logForEffect, 1e-12);
  EXPECT_EQ(ofEstimate.count, 6U);
  EXPECT_FALSE(bayesFactorOfEstimate({}));
  EXPECT_FALSE(bayesFactorOfEstimate(waldEstimate(1, 1, 0.95)));
}

/// Differences of subjects that come from the cases alone speak for an effect on these cases, and not on others.
TEST(BayesFactor, OfCrossedClustersDoesNotTakeCasesForAnEffect) {
  RandomNumbers random(9);
  int bySubjects = 0;
  int crossed = 0;
  for (int study = 0; study < 200; ++study) {
    std::vector<double> values;
    std::vector<bool> isSecond;
    std::vector<int> subjects;
    std::vector<int> cases;
    std::vector<double> ofCases(10);
    for (double& value : ofCases) {
      value = 0.5 * random.normal();
    }
    std::vector<double> differences(8);
    for (int subject = 0; subject < 8; ++subject) {
      for (int each = 0; each < 10; ++each) {
        values.push_back(ofCases[static_cast<size_t>(each)] + 0.5 * random.normal());
        isSecond.push_back(each % 2 == 1);
        subjects.push_back(subject);
        cases.push_back(each);
        differences[static_cast<size_t>(subject)] += (isSecond.back() ? values.back() : -values.back()) / 5;
      }
    }
    bySubjects += bayesFactorOfMean(differences)->forEffect > 3 ? 1 : 0;
    const Estimate difference = *clusteredMeanDifference(values, isSecond, subjects, cases);
    crossed += bayesFactorOfEstimate(difference)->forEffect > 3 ? 1 : 0;
  }
  EXPECT_GT(bySubjects, 60) << "of 200 studies without an effect";
  EXPECT_LT(crossed, 10);
}

TEST(BayesFactor, StaysFiniteInItsLogarithm) {
  const BayesFactor huge = bayesFactorOfT(500, 1000);
  EXPECT_TRUE(std::isfinite(huge.logForEffect));
  EXPECT_GT(huge.logForEffect, 1000);
  EXPECT_LT(bayesFactorOfT(0, 100000).logForEffect, -4);
}

TEST(BayesFactor, OfAShareIsTheIntegralOverShares) {
  expectGolden(
      {bayesFactorOfShare({12, 30}, 1.0 / 3)->logForEffect, bayesFactorOfShare({20, 30}, 1.0 / 3)->logForEffect,
       bayesFactorOfShare({20, 30}, 1.0 / 3, 2, 4)->logForEffect},
      "bayes/share", 1e-9);
  const BayesFactor one = *bayesFactorOfShare({1, 1}, 0.25);
  EXPECT_NEAR(one.forEffect, 2, 1e-12);  // 1/2 over 1/4
  EXPECT_NEAR(one.forNone, 0.5, 1e-12);
}

TEST(BayesFactor, SaysWhatItLacks) {
  EXPECT_EQ(bayesFactorOfMean({1}).reason(), "there are 1 differences, and 2 are needed");
  EXPECT_EQ(bayesFactorOfMean({2, 2, 2}).reason(), "all differences are the same");
  EXPECT_EQ(bayesFactorOfShare({0, 0}, 0.5).reason(), "there are no trials");
}

}  // namespace
}  // namespace ocelli::test
