// Intervals and probabilities.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/models/marginal_probability.h"
#include "analysis/models/quadrature.h"
#include "analysis/models/separation.h"
#include "tests/analysis_models/sample_models.h"

namespace ocelli {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const SampleSize kInferenceSize{20, 10, 2};

// Quantiles of t grow beyond all numbers as degrees of freedom fall towards 0.
TEST(EstimateOf, HasNoIntervalThatCannotBeTold) {
  for (const double df : {1e-300, 1e-20, 1e-6, 1e-3, 0.01, 0.1}) {
    const Estimate estimate = estimateOf(1, 0.5, df, 0.95);
    EXPECT_EQ(estimate.statistic, 2);
    EXPECT_LT(estimate.lower, -9) << df;
    EXPECT_GT(estimate.upper, 11) << df;
    EXPECT_GT(estimate.pValue, 0.3) << df;
    EXPECT_LE(estimate.pValue, 1) << df;
  }
  EXPECT_TRUE(std::isinf(estimateOf(1, 0.5, 1e-6, 0.95).upper));
  for (const double df : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Estimate estimate = estimateOf(1, 0.5, df, 0.95);
    EXPECT_EQ(estimate.value, 1);
    EXPECT_TRUE(std::isnan(estimate.lower));
    EXPECT_TRUE(std::isnan(estimate.pValue));
  }
  for (const double error : {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(estimateOf(1, error, 10, 0.95).pValue));
  }
  // Student's t with one and ten degrees of freedom, of tables.
  EXPECT_NEAR(estimateOf(0, 1, 1, 0.95).upper, 12.7062, 1e-4);
  EXPECT_NEAR(estimateOf(0, 1, 10, 0.95).upper, 2.2281, 1e-4);
}

// A likelihood that is flat in a variance says less than two levels do.
TEST(ContrastEstimate, HasOneDegreeOfFreedomAtLeast) {
  MixedModelFit fit;
  fit.coefficients = VectorXd::Constant(1, 0.3);
  fit.covariance = MatrixXd::Constant(1, 1, 0.04);
  fit.varianceParameterCovariance = MatrixXd::Constant(1, 1, 1e8);
  fit.covarianceGradients = {MatrixXd::Constant(1, 1, 0.1)};
  const Estimate estimate = contrastEstimate(fit, VectorXd::Ones(1));
  EXPECT_EQ(estimate.degreesOfFreedom, 1);
  EXPECT_NEAR(estimate.upper, 0.3 + 0.2 * 12.7062, 1e-4);
}

// Both are exact: moments of the normal distribution.
TEST(Quadrature, IntegratesPolynomials) {
  const HermiteRule rule = hermiteRule(5);
  const double root = std::sqrt(M_PI);
  EXPECT_NEAR(rule.weights.sum(), root, 1e-14);
  EXPECT_NEAR(rule.weights.dot(rule.points.array().pow(8).matrix()), root * 105 / 16, 1e-12);
  EXPECT_NEAR(hermiteRule(1).weights[0], root, 1e-14);
  EXPECT_NEAR(hermiteRule(1).points[0], 0, 1e-15);
}

TEST(MarginalProbability, IsTheMeanOverNewSubjects) {
  const FixedEffects fixed = sampleFixedEffects(kInferenceSize);
  const std::vector<RandomTerm> random = sampleRandomTerms(kInferenceSize, fixed);
  const BinomialMixedModel model(makeDesign(fixed, random));
  RandomNumbers numbers(8);
  const auto fit = model.fit(model.simulate(sampleBinomialTruth(), VectorXd::Ones(400), numbers));
  ASSERT_TRUE(fit) << fit.reason();
  const Condition condition = conditionOf(model, *fit, fixed, random);
  const Estimate average = averageProbability(*fit, condition);
  // Against responses drawn from the model: 2000 studies, of which subjects and items vary by some 0.06.
  double drawn = 0;
  for (int i = 0; i < 2000; ++i) {
    drawn += model.simulate(*fit, VectorXd::Ones(400), numbers).successes.mean() / 2000;
  }
  EXPECT_NEAR(average.value, drawn, 4 * 0.06 / std::sqrt(2000));
  EXPECT_LT(average.lower, average.value);
  EXPECT_GT(average.upper, average.value);

  // Derivatives by differences, in one direction.
  const VectorXd direction = VectorXd::LinSpaced(4, 1, -2);
  BinomialMixedFit moved = *fit;
  moved.coefficients += 1e-5 * direction;
  const double slope = (averageProbability(moved, condition).value - average.value) / 1e-5;
  BinomialMixedFit narrow = *fit;
  narrow.covariance = direction * direction.transpose();
  EXPECT_NEAR(averageProbability(narrow, condition).standardError, std::abs(slope), 1e-4);

  const Estimate none = averageProbabilityDifference(*fit, condition, condition);
  EXPECT_EQ(none.value, 0);
}

TEST(MarginalProbability, DiffersBetweenConditions) {
  const FixedEffects fixed = sampleFixedEffects(kInferenceSize);
  const BinomialMixedModel model(makeDesign(fixed, sampleRandomTerms(kInferenceSize, fixed)));
  RandomNumbers numbers(8);
  const auto fit = model.fit(model.simulate(sampleBinomialTruth(), VectorXd::Ones(400), numbers));
  ASSERT_TRUE(fit);
  Condition pinhole = conditionOf(model, *fit, fixed, sampleRandomTerms(kInferenceSize, fixed));
  Condition graph = pinhole;
  pinhole.fixed.col(1).setConstant(-0.5);
  graph.fixed.col(1).setConstant(0.5);
  const Estimate difference = averageProbabilityDifference(*fit, graph, pinhole);
  EXPECT_NEAR(difference.value, averageProbability(*fit, graph).value - averageProbability(*fit, pinhole).value, 1e-12);
  EXPECT_GT(difference.value, 0);
  EXPECT_LT(difference.pValue, 0.05);
  EXPECT_GT(difference.lower, -1);
}

std::vector<Eigen::Index> separated(const MatrixXd& rows, const std::vector<double>& successes) {
  const VectorXd y = Eigen::Map<const VectorXd>(successes.data(), static_cast<Eigen::Index>(successes.size()));
  return separatedColumns(rows, y, VectorXd::Ones(y.size()));
}

TEST(Separation, IsFoundWhereALineDividesTheAnswers) {
  MatrixXd rows(6, 2);
  rows << 1, -3, 1, -2, 1, -1, 1, 1, 1, 2, 1, 3;
  EXPECT_FALSE(separated(rows, {0, 0, 0, 1, 1, 1}).empty());
  EXPECT_TRUE(separated(rows, {0, 0, 1, 0, 1, 1}).empty());
  // Both answers at the border only.
  rows(3, 1) = -1;
  EXPECT_EQ(separated(rows, {0, 0, 0, 1, 1, 1}), (std::vector<Eigen::Index>{0, 1}));
  EXPECT_TRUE(separated(rows, {0, 1, 0, 1, 1, 0}).empty());
}

// Against all directions of a fine fan, over random small tables.
TEST(Separation, IsThatOfAllDirectionsInThePlane) {
  RandomNumbers numbers(6);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    MatrixXd rows(6, 2);
    std::vector<double> successes;
    for (Eigen::Index row = 0; row < 6; ++row) {
      rows.row(row) << 1, static_cast<double>(numbers.below(5)) - 2;
      successes.push_back(static_cast<double>(numbers.below(2)));
    }
    if (rows.col(1).minCoeff() == rows.col(1).maxCoeff()) {
      continue;
    }
    // Borders lie at x = -2, -1.5, ... 2, on either side, or beyond all.
    bool expected = false;
    for (double border = -3; border <= 3; border += 0.5) {
      for (const double sign : {-1.0, 1.0}) {
        bool holds = true;
        bool strict = false;
        for (Eigen::Index row = 0; row < 6; ++row) {
          const double side = sign * (rows(row, 1) - border) * (successes[static_cast<size_t>(row)] > 0 ? 1 : -1);
          holds = holds && side >= 0;
          strict = strict || side > 0;
        }
        expected = expected || (holds && strict);
      }
    }
    const double sum = Eigen::Map<const VectorXd>(successes.data(), 6).sum();
    expected = expected || sum == 0 || sum == 6;
    EXPECT_EQ(!separated(rows, successes).empty(), expected) << rows;
    found += expected ? 1 : 0;
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(found, 250);
}

}  // namespace
}  // namespace ocelli
