#include "analysis/inference/crossed_clusters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/inference/accelerated_failure_time.h"
#include "analysis/inference/cox.h"
#include "analysis/inference/equivalence.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

TEST(CrossedClusters, varianceByHand) {
  const std::vector<double> values{1, 2, 3, -6};
  // By the first ones: 3 and -3, squares 18, factor 2. By the second ones: 4 and -4, squares 32, factor 2. By
  // trial: 50.
  EXPECT_DOUBLE_EQ(clusteredVariance(values, crossedClusters({0, 0, 1, 1}, {})), 36);
  EXPECT_DOUBLE_EQ(clusteredVariance(values, crossedClusters({0, 0, 1, 1}, {7, 9, 7, 9})), 36 + (64 - 50));
  // Where trials of a case cancel each other, cases add nothing.
  EXPECT_DOUBLE_EQ(clusteredVariance({4, -4, 1, -1}, crossedClusters({0, 1, 0, 1}, {7, 7, 9, 9})), 100);
}

TEST(CrossedClusters, differenceOfSubjectsAloneIsThatOfAPairedTest) {
  RandomNumbers numbers(3);
  std::vector<double> values;
  std::vector<bool> isSecond;
  std::vector<int> subjects;
  std::vector<double> differences(9);
  for (int subject = 0; subject < 9; ++subject) {
    for (const bool second : {false, true}) {
      const int trials = 2 + (subject + second) % 3;
      for (int trial = 0; trial < trials; ++trial) {
        values.push_back(numbers.normal() + subject);
        isSecond.push_back(second);
        subjects.push_back(subject);
        differences[static_cast<size_t>(subject)] += (second ? values.back() : -values.back()) / trials;
      }
    }
  }
  const Estimate estimate = *clusteredMeanDifference(values, isSecond, subjects, {});
  const EquivalenceTest paired = *equivalenceOfPairedMeans(differences, {-1, 1});
  EXPECT_NEAR(estimate.value, paired.difference.value, 1e-12);
  EXPECT_NEAR(estimate.standardError, paired.difference.standardError, 1e-12);
  EXPECT_NEAR(estimate.pValue, paired.difference.pValue, 1e-12);
  EXPECT_EQ(estimate.degreesOfFreedom, 8);
}

TEST(CrossedClusters, casesThatDifferWidenTheInterval) {
  // Four subjects that agree in which of four cases are easy; two cases have each view.
  std::vector<double> values;
  std::vector<bool> isSecond;
  std::vector<int> subjects;
  std::vector<int> cases;
  for (int subject = 0; subject < 4; ++subject) {
    for (int each = 0; each < 4; ++each) {
      values.push_back((each == 0 || each == 3 ? 1 : 0) + (each == 1 && subject == 0 ? 0.5 : 0));
      isSecond.push_back(each % 2 == 1);
      subjects.push_back(subject);
      cases.push_back(each);
    }
  }
  const double bySubject = clusteredMeanDifference(values, isSecond, subjects, {})->standardError;
  const double byBoth = clusteredMeanDifference(values, isSecond, subjects, cases)->standardError;
  EXPECT_GT(byBoth, 4 * bySubject);
}

TEST(CrossedClusters, sayWhatCannotBeHad) {
  EXPECT_FALSE(clusteredMean({}, crossedClusters({}, {})));
  EXPECT_FALSE(clusteredMean({1, 2}, crossedClusters({3, 3}, {})));
  EXPECT_FALSE(clusteredMean({1, 2}, crossedClusters({3, 4}, {5, 5})));
  EXPECT_FALSE(clusteredMean({1, 1}, crossedClusters({3, 4}, {5, 6})));
  EXPECT_FALSE(clusteredMeanDifference({1, 2}, {false, true}, {3, 4}, {}));
}

/// 20 subjects with 12 cases; x is of the case.
SurvivalData crossedTimes() {
  RandomNumbers numbers(5);
  std::vector<double> ofCases;
  for (int each = 0; each < 12; ++each) {
    ofCases.push_back(0.5 * numbers.normal());
  }
  SurvivalData data;
  data.covariates.push_back({"x", {}});
  for (int subject = 0; subject < 20; ++subject) {
    const double ofSubject = 0.3 * numbers.normal();
    for (int each = 0; each < 12; ++each) {
      data.times.push_back({std::exp(ofSubject + ofCases[static_cast<size_t>(each)] + 0.5 * numbers.normal()), true});
      data.covariates[0].values.push_back(each % 2);
      data.clusters.push_back(subject);
    }
  }
  return data;
}

template <class Estimate>
void expectErrorsForFewClusters(const Estimate& estimateOf) {
  SurvivalData data = crossedTimes();
  const auto large = estimateOf(data);
  data.fewClusters = true;
  const auto few = estimateOf(data);
  EXPECT_EQ(few.value, large.value);
  // Each subject has all cases: leaving one out is the factor of few clusters, but for the second order, whose size is
  // that of a subject's share, 1/20.
  EXPECT_NEAR(few.standardError, large.standardError * std::sqrt(20.0 / 19), large.standardError / 20);
  EXPECT_NEAR(few.upper - few.value, few.standardError * studentQuantile(0.975, 19), 1e-12);
  for (size_t i = 0; i < data.times.size(); ++i) {
    data.items.push_back(static_cast<int>(i % 12));
  }
  const auto crossed = estimateOf(data);
  EXPECT_EQ(crossed.value, large.value);
  EXPECT_GT(crossed.standardError, 1.4 * few.standardError);  // cases of the two kinds differ more than subjects do
  EXPECT_GE(crossed.degreesOfFreedom, 11);
  EXPECT_LT(crossed.degreesOfFreedom, 19 + 11);
}

TEST(CrossedClusters, ofRegressionsOfTimes) {
  expectErrorsForFewClusters([](const SurvivalData& data) { return fitCox(data)->terms[0].logHazardRatio; });
  expectErrorsForFewClusters([](const SurvivalData& data) { return fitLogNormal(data)->terms[0].logTimeRatio; });
}

}  // namespace
}  // namespace ocelli::test
