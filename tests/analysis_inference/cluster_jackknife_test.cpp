// Errors of regressions of times for few subjects and cases, against fits that leave each out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "analysis/base/distributions.h"
#include "tests/analysis_inference/clustered_searches.h"

namespace ocelli::test {
namespace {

void addMoving(SurvivalData& data) {
  data.covariates.push_back({"moving", {}});
  for (const int item : data.items) {
    data.covariates[1].values.push_back(item % 2);
  }
}

/// Without clusters: the fit itself.
SurvivalData withoutTrials(const SurvivalData& data, const std::vector<int>& labels, int label) {
  SurvivalData rest;
  for (const Covariate& covariate : data.covariates) {
    rest.covariates.push_back({covariate.name, {}});
  }
  for (size_t i = 0; i < data.times.size(); ++i) {
    if (labels[i] != label) {
      rest.times.push_back(data.times[i]);
      for (size_t j = 0; j < rest.covariates.size(); ++j) {
        rest.covariates[j].values.push_back(data.covariates[j].values[i]);
      }
    }
  }
  return rest;
}

/// The slow reference: the variance from fits without each label.
double literalJackknife(const SurvivalData& data, const std::vector<int>& labels, const Fit& fit) {
  const double all = fit(withoutTrials(data, labels, -1))->value;
  const int count = *std::max_element(labels.begin(), labels.end()) + 1;
  double squares = 0;
  for (int label = 0; label < count; ++label) {
    const double change = fit(withoutTrials(data, labels, label))->value - all;
    squares += change * change;
  }
  return squares * (count - 1) / count;
}

double variance(SurvivalData data, const std::vector<int>& clusters, const Fit& fit) {
  data.clusters = clusters;
  data.items.clear();
  const double error = fit(data)->standardError;
  return error * error;
}

void expectLiteral(const SurvivalData& data, const Fit& fit, double tolerance, const char* what) {
  const double bySubject = literalJackknife(data, data.clusters, fit);
  const double byCase = literalJackknife(data, data.items, fit);
  EXPECT_NEAR(variance(data, data.clusters, fit) / bySubject, 1, tolerance) << what << ", subjects";
  EXPECT_NEAR(variance(data, data.items, fit) / byCase, 1, tolerance) << what << ", cases";
}

// One step of the search stands for all of it. That of Cox regression takes risk sets as they are with the cluster,
// which shows where there are few.
TEST(ClusterJackknife, IsThatOfFittingAgainWithoutEachSubjectAndCase) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    RandomNumbers random(seed);
    SurvivalData data = searches(8, 10, {.ofCaseViews = 0.4}, random);
    expectLiteral(data, coxTerm, 0.35, "Cox");
    expectLiteral(data, logNormalTerm, 0.06, "log-normal");
    addMoving(data);
    std::swap(data.covariates[0], data.covariates[1]);
    expectLiteral(data, coxTerm, 0.35, "Cox, moving");
    expectLiteral(data, logNormalTerm, 0.06, "log-normal, moving");
    SurvivalData more = searches(24, 30, {.ofCaseViews = 0.4}, random);
    expectLiteral(more, coxTerm, 0.04, "Cox, 24 subjects and 30 cases");
    expectLiteral(more, logNormalTerm, 0.02, "log-normal, 24 subjects and 30 cases");
  }
}

TEST(ClusterJackknife, OfBalancedTimesIsThePairedTest) {
  // Nothing is censored: the effect of the view is the mean of the subjects' differences.
  RandomNumbers random(4);
  SurvivalData data = searches(8, 10, {}, random);
  std::vector<double> differences(8);
  for (size_t i = 0; i < data.times.size(); ++i) {
    data.times[i].observed = true;
    differences[static_cast<size_t>(data.clusters[i])] +=
        2 * data.covariates[0].values[i] * std::log(data.times[i].seconds) / 10;
  }
  double mean = 0;
  double squares = 0;
  for (const double difference : differences) {
    mean += difference / 8;
  }
  for (const double difference : differences) {
    squares += (difference - mean) * (difference - mean);
  }
  data.items.clear();
  const Estimate view = *logNormalTerm(data);
  EXPECT_NEAR(view.value, mean, 1e-9);
  // Up to the spread, which a step changes with.
  EXPECT_NEAR(view.standardError, std::sqrt(squares / 7 / 8), 0.02 * view.standardError);
  EXPECT_EQ(view.degreesOfFreedom, 7);
}

TEST(ClusterJackknife, AddsWhatCasesHaveMoreThanTheirTrials) {
  RandomNumbers random(5);
  const SurvivalData data = searches(8, 10, {.ofCaseViews = 0.8}, random);
  std::vector<int> cells;
  for (size_t i = 0; i < data.times.size(); ++i) {
    cells.push_back(data.clusters[i] * 10 + data.items[i]);
  }
  for (const Fit& fit : {Fit(coxTerm), Fit(logNormalTerm)}) {
    SurvivalData plain = data;
    plain.fewClusters = false;
    const double byBoth = variance(plain, cells, fit);
    const double bySubject = variance(data, data.clusters, fit);
    const double byCase = variance(data, data.items, fit);
    const double sum = bySubject + byCase - byBoth;
    const Estimate crossed = *fit(data);
    // What other coefficients share with it moves the positive part a little.
    EXPECT_NEAR(crossed.standardError, std::sqrt(sum), 0.03 * crossed.standardError);
    // Satterthwaite's: more than the 7 of the subjects, as cases vary more here.
    const double degrees = sum * sum / (bySubject * bySubject / 7 + byCase * byCase / 9);
    ASSERT_GT(degrees, 8);
    EXPECT_NEAR(crossed.degreesOfFreedom, degrees, 0.1 * degrees);
  }
}

TEST(ClusterJackknife, WhatOneCaseAloneTellsHasNoError) {
  RandomNumbers random(6);
  SurvivalData data = searches(8, 6, {}, random);
  data.covariates.push_back({"moving", {}});
  for (const int item : data.items) {
    data.covariates[1].values.push_back(item == 5 ? 1 : 0);
  }
  const auto cox = fitCox(data);
  ASSERT_TRUE(cox) << cox.reason();
  const auto logNormal = fitLogNormal(data);
  ASSERT_TRUE(logNormal) << logNormal.reason();
  for (const auto& [view, moving] : {std::pair(cox->terms[0].logHazardRatio, cox->terms[1].logHazardRatio),
                                     std::pair(logNormal->terms[0].logTimeRatio, logNormal->terms[1].logTimeRatio)}) {
    EXPECT_TRUE(std::isfinite(view.pValue));
    EXPECT_TRUE(std::isfinite(moving.value));
    EXPECT_TRUE(std::isnan(moving.lower));
    EXPECT_TRUE(std::isnan(moving.pValue));
  }
  EXPECT_TRUE(std::isnan(cox->wald.pValue));
  EXPECT_TRUE(std::isnan(logNormal->intercept.standardError));
}

}  // namespace
}  // namespace ocelli::test
