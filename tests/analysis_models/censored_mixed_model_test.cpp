#include "analysis/models/censored_mixed_model.h"

#include <gtest/gtest.h>

#include "analysis/models/linear_mixed_model.h"
#include "tests/analysis_models/dense_reference.h"
#include "tests/analysis_models/golden_designs.h"
#include "tests/analysis_models/sample_models.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void expectClose(double got, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(got, expected, tolerance * std::max(std::abs(expected), 1e-3)) << what;
}

/// Without a censored row. Tolerances: both searches stop where a step would lower the deviance by 1e-10, so that
/// variances agree to about 1e-5; what depends on them less strongly is nearer, and degrees of freedom, which are of
/// second differences, are less near.
void expectLinearModel(const Design& design, const VectorXd& response) {
  const auto linear = LinearMixedModel(design).fit(response);
  const auto censored =
      CensoredMixedModel(design).fitRestricted({response, std::vector<bool>(static_cast<size_t>(response.size()))});
  ASSERT_TRUE(linear);
  ASSERT_TRUE(censored) << censored.reason();
  EXPECT_TRUE(censored->convergence.converged) << censored->convergence.reason;
  EXPECT_EQ(censored->censoredRows, 0);
  EXPECT_NEAR(censored->deviance, linear->deviance, 1e-7 * std::abs(linear->deviance));
  EXPECT_EQ(censored->restricted, linear->restricted);
  EXPECT_EQ(censored->parameters, linear->parameters);
  EXPECT_EQ(censored->boundary, linear->boundary);
  expectClose(censored->residualDeviation, linear->residualDeviation, 1e-5, "residual deviation");
  for (Index i = 0; i < linear->coefficients.size(); ++i) {
    const std::string& name = linear->names[static_cast<size_t>(i)];
    const Estimate expected = *coefficientEstimate(*linear, name);
    const Estimate got = *coefficientEstimate(*censored, name);
    expectClose(got.value, expected.value, 1e-6, name);
    expectClose(got.standardError, expected.standardError, 1e-5, name + ": standard error");
    expectClose(got.degreesOfFreedom, expected.degreesOfFreedom, 1e-3, name + ": degrees of freedom");
    EXPECT_NEAR(got.lower, expected.lower, 1e-4 * expected.standardError) << name << ": lower";
  }
  for (size_t term = 0; term < linear->random.size(); ++term) {
    EXPECT_LT((censored->random[term].standardDeviations - linear->random[term].standardDeviations).norm(),
              1e-4 * linear->residualDeviation);
    EXPECT_LT((censored->random[term].effects - linear->random[term].effects).lpNorm<Eigen::Infinity>(),
              1e-4 * linear->residualDeviation);
  }
  EXPECT_LT((censored->fitted - linear->fitted).lpNorm<Eigen::Infinity>(), 1e-4 * linear->residualDeviation);
  EXPECT_LT((censored->residuals - linear->residuals).lpNorm<Eigen::Infinity>(), 1e-4 * linear->residualDeviation);
}

TEST(CensoredMixedModel, WithoutCensoredRowsIsTheLinearOne) {
  const GoldenData dyestuff("dyestuff");
  expectLinearModel(interceptsDesign(dyestuff, {"Batch"}), dyestuff.vector("Yield"));
  const GoldenData none("dyestuff2");
  expectLinearModel(interceptsDesign(none, {"Batch"}), none.vector("Yield"));
  const GoldenData sleep("sleepstudy");
  expectLinearModel(sleepDesign(sleep, true), sleep.vector("Reaction"));
  expectLinearModel(sleepDesign(sleep, false), sleep.vector("Reaction"));
  const GoldenData penicillin("penicillin");
  expectLinearModel(interceptsDesign(penicillin, {"plate", "sample"}), penicillin.vector("diameter"));
  const GoldenData pastes("pastes");
  expectLinearModel(interceptsDesign(pastes, {"sample", "batch"}), pastes.vector("strength"));
  const GoldenData find("find");
  expectLinearModel(findDesign(find), find.vector("y"));
}

/// `data` stopped at the quantile: a share of its rows.
CensoredResponse stoppedAt(const VectorXd& response, double share) {
  VectorXd sorted = response;
  std::sort(sorted.begin(), sorted.end());
  const double limit = sorted[static_cast<Index>((1 - share) * static_cast<double>(sorted.size()))];
  CensoredResponse stopped{response.cwiseMin(limit), {}};
  for (const double value : response) {
    stopped.censored.push_back(value > limit);
  }
  return stopped;
}

/// The sum over a fine grid is exact to rounding, 25 points to 1e-6. Laplace's approximation is not: with half of 5
/// rows a level censored and levels that differ a lot, it is off by 0.06 in -2 log likelihood.
TEST(CensoredMixedModel, LikelihoodIsTheIntegral) {
  const GoldenData data("dyestuff");
  const Design design = interceptsDesign(data, {"Batch"});
  const CensoredMixedModel model(design);
  const VectorXd coefficients = VectorXd::Constant(1, 1530);
  for (const double share : {0.1, 0.5}) {
    const CensoredResponse response = stoppedAt(data.vector("Yield"), share);
    for (const double theta : {0.3, 0.8, 2.0}) {
      const VectorXd theta1 = VectorXd::Constant(1, theta);
      const double expected = gridCensoredDeviance(design, response, theta, 50, coefficients);
      EXPECT_NEAR(model.deviance(response, theta1, 50, coefficients, 25), expected, 1e-6) << share << " " << theta;
      const double laplace = model.deviance(response, theta1, 50, coefficients);
      EXPECT_NEAR(laplace, expected, 0.1) << share << " " << theta;
      EXPECT_GT(std::abs(laplace - expected), 1e-6);
    }
  }
}

/// With the integral over the one coefficient too, from far below to far above.
TEST(CensoredMixedModel, RestrictedLikelihoodIsTheIntegralOverCoefficients) {
  const GoldenData data("dyestuff");
  const Design design = interceptsDesign(data, {"Batch"});
  const CensoredMixedModel model(design);
  const CensoredResponse response = stoppedAt(data.vector("Yield"), 0.3);
  const VectorXd theta = VectorXd::Constant(1, 0.8);
  const double center = model.deviance(response, theta, 50, VectorXd::Constant(1, 1530), 25);
  double sum = 0;
  const double step = 2;
  for (double coefficient = 1300; coefficient <= 1800; coefficient += step) {
    const double deviance = model.deviance(response, theta, 50, VectorXd::Constant(1, coefficient), 25);
    sum += step * std::exp((center - deviance) / 2);
  }
  EXPECT_NEAR(model.restrictedDeviance(response, theta, 50), center - 2 * std::log(sum), 0.02);
}

struct Mean {
  double censored = 0;
  double atLimit = 0;
  double share = 0;
  int covered = 0;
};

/// Searches of 20 subjects and 12 places, a quarter of them stopped.
TEST(CensoredMixedModel, IsNotDrawnInByTimeOuts) {
  const Design design = sampleDesign({20, 12, 2});
  const LinearMixedModel linear(design);
  const CensoredMixedModel censored(design);
  LinearMixedFit truth = sampleLinearTruth();
  const double limit = 2.95;
  const int studies = 60;
  Mean mean;
  for (int study = 0; study < studies; ++study) {
    RandomNumbers numbers(5, static_cast<uint64_t>(study));
    const VectorXd response = linear.simulate(truth, numbers);
    CensoredResponse stopped{response.cwiseMin(limit), {}};
    for (const double value : response) {
      stopped.censored.push_back(value > limit);
      mean.share += value > limit ? 1.0 / static_cast<double>(studies * response.size()) : 0;
    }
    const auto fit = censored.fitRestricted(stopped);
    ASSERT_TRUE(fit) << fit.reason();
    EXPECT_TRUE(fit->convergence.converged) << fit->convergence.reason;
    const Estimate view = contrastEstimate(*fit, VectorXd::Unit(4, 1));
    mean.censored += view.value / studies;
    mean.covered += view.lower <= -0.4 && -0.4 <= view.upper ? 1 : 0;
    mean.atLimit += linear.fit(stopped.values)->coefficients[1] / studies;
  }
  EXPECT_NEAR(mean.share, 0.26, 0.03);
  // The estimates have a standard deviation of 0.1, so that their mean is known to 0.013.
  EXPECT_NEAR(mean.censored, -0.4, 0.04);
  EXPECT_GT(mean.atLimit, -0.33);
  EXPECT_GE(mean.covered, 52);
}

TEST(CensoredMixedModel, SaysWhatItCannotEstimate) {
  const Design design = sampleDesign({8, 6, 2});
  const CensoredMixedModel model(design);
  RandomNumbers numbers(6);
  const VectorXd response = LinearMixedModel(design).simulate(sampleLinearTruth(), numbers);
  std::vector<bool> censored(static_cast<size_t>(design.rows()), true);
  EXPECT_EQ(model.fitRestricted({response, censored}).reason(), "all responses are censored");
  // All of one view.
  for (size_t row = 0; row < censored.size(); ++row) {
    censored[row] = design.fixed(static_cast<Index>(row), 1) > 0;
  }
  EXPECT_EQ(model.fitRestricted({response, censored}).reason(),
            "all responses are censored in some combination of conditions, where (intercept), view=gc have no finite "
            "estimates");
  censored.assign(censored.size(), true);
  censored[0] = censored[1] = censored[2] = false;
  EXPECT_FALSE(model.fitRestricted({response, censored}));
  EXPECT_THROW(model.fitRestricted({response.head(3), censored}), std::exception);
}

}  // namespace
}  // namespace ocelli
