// The fast likelihoods against their definitions.
#include <gtest/gtest.h>

#include "tests/analysis_models/dense_reference.h"
#include "tests/analysis_models/sample_models.h"

namespace ocelli {
namespace {

Eigen::VectorXd draw(RandomNumbers& numbers, Eigen::Index size, double scale) {
  return Eigen::VectorXd::NullaryExpr(size, [&] { return scale * numbers.normal(); });
}

// Tolerance: rounding of matrices of some 50 rows.
TEST(MixedModelReference, LinearDevianceIsThatOfTheWholeCovarianceMatrix) {
  RandomNumbers numbers(1);
  for (const bool correlated : {true, false}) {
    for (const double scale : {1.0, 1e6}) {
      const SampleSize size{7, 8, 1};
      const FixedEffects fixed = sampleFixedEffects(size, scale);
      std::vector<RandomTerm> random = sampleRandomTerms(size, fixed, correlated);
      addSlope(random[1], "session", fixed);
      const LinearMixedModel model(makeDesign(fixed, random));
      for (int i = 0; i < 5; ++i) {
        const Eigen::VectorXd response = 100 + draw(numbers, fixed.rows(), 3).array();
        Eigen::VectorXd theta = draw(numbers, correlated ? 6 : 5, 1);
        theta.tail(2) /= scale;
        for (const bool restricted : {false, true}) {
          const double expected = denseGaussianDeviance(model.design(), response, theta, restricted);
          EXPECT_NEAR(model.deviance(response, theta, restricted), expected, scale == 1 ? 1e-8 : 1e-5);
        }
      }
    }
  }
}

// More effects beside the first term's than are kept as a whole matrix.
TEST(MixedModelReference, ManyEffectsOfSeveralTermsAreSparse) {
  RandomNumbers numbers(4);
  std::vector<std::string> subjects;
  std::vector<std::string> sessions;
  for (int row = 0; row < 840; ++row) {
    subjects.push_back(std::to_string(row % 210));
    sessions.push_back(std::to_string(row % 420));
  }
  FixedEffects fixed(840);
  fixed.addIntercept();
  const Eigen::VectorXd x = draw(numbers, 840, 1);
  fixed.addNumber("x", {x.begin(), x.end()});
  std::vector<RandomTerm> random = {randomIntercepts("subject", subjects), randomIntercepts("session", sessions)};
  addSlope(random[0], "x", fixed);
  const LinearMixedModel model(makeDesign(fixed, random));
  const Eigen::VectorXd response = draw(numbers, 840, 2);
  const Eigen::VectorXd theta = draw(numbers, 4, 1);
  EXPECT_NEAR(model.deviance(response, theta, true), denseGaussianDeviance(model.design(), response, theta, true),
              1e-7);
  const auto fit = model.fit(response);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->convergence.converged) << fit->convergence.reason;
}

TEST(MixedModelReference, LaplaceDevianceIsThatOfTheWholeHessian) {
  RandomNumbers numbers(2);
  const SampleSize size{7, 8, 1};
  const BinomialMixedModel model(sampleDesign(size));
  const Eigen::VectorXd trials =
      Eigen::VectorXd::NullaryExpr(model.design().rows(), [&] { return 1 + static_cast<double>(numbers.below(4)); });
  for (int i = 0; i < 5; ++i) {
    const BinomialResponse response = model.simulate(sampleBinomialTruth(), trials, numbers);
    const Eigen::VectorXd theta = draw(numbers, 4, 1);
    const Eigen::VectorXd beta = draw(numbers, 4, 1);
    EXPECT_NEAR(model.deviance(response, theta, beta), denseLaplaceDeviance(model.design(), response, theta, beta),
                1e-9);
  }
}

// The grid is exact to rounding; 25 points are so to about 1e-7 for 8 rows a subject, and Laplace's one is not.
TEST(MixedModelReference, QuadratureIsTheIntegral) {
  RandomNumbers numbers(3);
  const SampleSize size{6, 8, 1};
  const FixedEffects fixed = sampleFixedEffects(size);
  std::vector<RandomTerm> random = sampleRandomTerms(size, fixed);
  random[0] = randomIntercepts("subject", [&] {
    std::vector<std::string> labels;
    for (const int level : random[0].levelOfRow) {
      labels.push_back(random[0].levels[static_cast<size_t>(level)]);
    }
    return labels;
  }());
  const BinomialMixedModel model(makeDesign(fixed, {random[0]}));
  const Eigen::VectorXd trials = Eigen::VectorXd::Ones(fixed.rows());
  BinomialMixedFit truth = sampleBinomialTruth();
  truth.theta = Eigen::VectorXd::Constant(1, 0.9);
  const BinomialResponse response = model.simulate(truth, trials, numbers);
  for (const double theta : {0.3, 1.0, 2.0}) {
    const Eigen::VectorXd theta1 = Eigen::VectorXd::Constant(1, theta);
    const double expected = gridBinomialDeviance(model.design(), response, theta, truth.coefficients);
    EXPECT_NEAR(model.deviance(response, theta1, truth.coefficients, 25), expected, 1e-6) << theta;
    EXPECT_NEAR(model.deviance(response, theta1, truth.coefficients, 1),
                denseLaplaceDeviance(model.design(), response, theta1, truth.coefficients), 1e-9);
    EXPECT_GT(std::abs(model.deviance(response, theta1, truth.coefficients, 1) - expected), 1e-5);
  }
}

}  // namespace
}  // namespace ocelli
