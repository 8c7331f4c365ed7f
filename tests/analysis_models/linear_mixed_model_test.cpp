// Against lme4 and lmerTest.
#include "analysis/models/linear_mixed_model.h"

#include <gtest/gtest.h>

#include "tests/analysis_models/golden_designs.h"

namespace ocelli {
namespace {

LinearMixedModel intercepts(const GoldenData& data, const std::vector<std::string>& groups) {
  return LinearMixedModel(interceptsDesign(data, groups));
}

LinearMixedModel sleepModel(const GoldenData& data, bool correlated) {
  return LinearMixedModel(sleepDesign(data, correlated));
}

LinearMixedModel findModel(const GoldenData& data, bool interaction = true) {
  return LinearMixedModel(findDesign(data, interaction));
}

/// Relative to the expected value, or to 1 where that is near 0.
void expectNear(double got, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(got, expected, tolerance * std::max(std::abs(expected), 1e-3)) << what;
}

/// Tolerances: the deviance to 1e-4 and coefficients to 1e-5, as the toolkit promises; what depends on theta to first
/// order is as exact as either search for the optimum; lmerTest's own differences limit the degrees of freedom.
void expectGolden(const LinearMixedModel& model, const Eigen::VectorXd& response, const nlohmann::json& golden) {
  const Estimable<LinearMixedFit> fit = model.fit(response, golden.at("restricted").get<bool>());
  ASSERT_TRUE(fit) << fit.reason();
  EXPECT_TRUE(fit->convergence.converged) << fit->convergence.reason;
  EXPECT_NEAR(fit->deviance, golden.at("criterion").get<double>(), 1e-6);
  EXPECT_EQ(fit->singular, golden.at("singular").get<bool>());
  const std::vector<double> coefficients = numbersOf(golden.at("coefficients"));
  const std::vector<double> standardErrors = numbersOf(golden.at("standardErrors"));
  const std::vector<double> df = numbersOf(golden.at("df"));
  const std::vector<double> p = numbersOf(golden.at("p"));
  ASSERT_EQ(fit->coefficients.size(), static_cast<Eigen::Index>(coefficients.size()));
  for (size_t i = 0; i < coefficients.size(); ++i) {
    const Estimate estimate =
        contrastEstimate(*fit, Eigen::VectorXd::Unit(fit->coefficients.size(), static_cast<Eigen::Index>(i)));
    expectNear(estimate.value, coefficients[i], 1e-5, "coefficient " + fit->names[i]);
    expectNear(estimate.standardError, standardErrors[i], 1e-5, "standard error " + fit->names[i]);
    expectNear(estimate.degreesOfFreedom, df[i], 1e-3, "degrees of freedom " + fit->names[i]);
    EXPECT_NEAR(estimate.pValue / p[i], 1, 2e-2) << fit->names[i];
  }
  expectNear(fit->residualDeviation, golden.at("sigma").get<double>(), 1e-5, "residual");
  const std::vector<double> theta = numbersOf(golden.at("theta"));
  for (size_t i = 0; i < theta.size(); ++i) {
    EXPECT_NEAR(fit->theta[static_cast<Eigen::Index>(i)], theta[i], 1e-4) << "theta " << i;
  }
  const std::vector<double> deviations = numbersOf(golden.at("deviations"));
  size_t next = 0;
  for (const RandomTermFit& term : fit->random) {
    for (const double deviation : term.standardDeviations) {
      EXPECT_NEAR(deviation, deviations[next], 1e-4 * fit->residualDeviation) << term.group;
      ++next;
    }
  }
  const std::vector<double> effects = numbersOf(golden.at("firstEffects"));
  for (size_t i = 0; i < effects.size(); ++i) {
    EXPECT_NEAR(fit->random[0].effects(static_cast<Eigen::Index>(i), 0), effects[i], 1e-4 * fit->residualDeviation);
  }
  const std::vector<double> fitted = numbersOf(golden.at("fitted"));
  for (size_t i = 0; i < fitted.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(fit->fitted[row], fitted[i], 1e-4 * fit->residualDeviation);
    EXPECT_NEAR(fit->residuals[row], response[row] - fitted[i], 1e-4 * fit->residualDeviation);
  }
}

TEST(LinearMixedModel, DyestuffIsThatOfLme4) {
  const GoldenData data("dyestuff");
  const LinearMixedModel model = intercepts(data, {"Batch"});
  expectGolden(model, data.vector("Yield"), data.model("ml"));
  expectGolden(model, data.vector("Yield"), data.model("reml"));
  // As published.
  EXPECT_NEAR(model.fit(data.vector("Yield"), false)->deviance, 327.327060, 1e-5);
  EXPECT_NEAR(model.fit(data.vector("Yield"), true)->deviance, 319.654277, 1e-5);
}

TEST(LinearMixedModel, SleepstudyIsThatOfLme4) {
  const GoldenData data("sleepstudy");
  const LinearMixedModel model = sleepModel(data, true);
  expectGolden(model, data.vector("Reaction"), data.model("ml"));
  expectGolden(model, data.vector("Reaction"), data.model("reml"));
  EXPECT_NEAR(model.fit(data.vector("Reaction"), false)->deviance, 1751.93934, 1e-5);
  EXPECT_NEAR(model.fit(data.vector("Reaction"), true)->deviance, 1743.6283, 1e-4);
  expectGolden(sleepModel(data, false), data.vector("Reaction"), data.model("uncorrelated"));
}

TEST(LinearMixedModel, CrossedAndNestedTermsAreThoseOfLme4) {
  const GoldenData penicillin("penicillin");
  const LinearMixedModel crossed = intercepts(penicillin, {"plate", "sample"});
  expectGolden(crossed, penicillin.vector("diameter"), penicillin.model("ml"));
  expectGolden(crossed, penicillin.vector("diameter"), penicillin.model("reml"));
  EXPECT_NEAR(crossed.fit(penicillin.vector("diameter"), false)->deviance, 332.18835, 1e-5);
  const GoldenData pastes("pastes");
  expectGolden(intercepts(pastes, {"sample", "batch"}), pastes.vector("strength"), pastes.model("reml"));
}

TEST(LinearMixedModel, SubjectsByItemsAreThoseOfLme4) {
  const GoldenData data("find");
  const LinearMixedModel model = findModel(data);
  expectGolden(model, data.vector("y"), data.model("ml"));
  expectGolden(model, data.vector("y"), data.model("reml"));
}

TEST(LinearMixedModel, LikelihoodRatioIsThatOfLme4) {
  const GoldenData data("find");
  const auto larger = findModel(data).fit(data.vector("y"), false);
  const auto smaller = findModel(data, false).fit(data.vector("y"), false);
  const Estimable<Estimate> ratio = likelihoodRatio(*smaller, *larger);
  ASSERT_TRUE(ratio) << ratio.reason();
  const nlohmann::json& golden = data.model("likelihoodRatio");
  EXPECT_NEAR(ratio->statistic, golden.at("statistic").get<double>(), 1e-6);
  EXPECT_EQ(ratio->degreesOfFreedom, 1);
  EXPECT_NEAR(ratio->pValue, golden.at("p").get<double>(), 1e-7);
  EXPECT_FALSE(likelihoodRatio(*larger, *smaller));
  EXPECT_FALSE(likelihoodRatio(*findModel(data, false).fit(data.vector("y")), *findModel(data).fit(data.vector("y"))));
}

TEST(LinearMixedModel, NoVarianceBetweenGroupsIsASingularFit) {
  const GoldenData data("dyestuff2");
  const LinearMixedModel model = intercepts(data, {"Batch"});
  expectGolden(model, data.vector("Yield"), data.model("ml"));
  const auto fit = model.fit(data.vector("Yield"), false);
  EXPECT_EQ(fit->theta[0], 0);
  ASSERT_EQ(fit->boundary.size(), 1U);
  EXPECT_EQ(fit->boundary[0], "the variance of (intercept) by Batch is 0");
  EXPECT_EQ(fit->warnings.size(), 1U);
}

}  // namespace
}  // namespace ocelli
