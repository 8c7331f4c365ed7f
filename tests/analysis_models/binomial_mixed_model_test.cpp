// Against lme4's glmer.
#include "analysis/models/binomial_mixed_model.h"

#include <gtest/gtest.h>

#include "tests/analysis_models/golden.h"

namespace ocelli {
namespace {

BinomialMixedModel cbppModel(const GoldenData& data) {
  FixedEffects fixed(56);
  fixed.addIntercept();
  fixed.addFactor("period", data.labels("period"), {"1", "2", "3", "4"}, Coding::kTreatment);
  return BinomialMixedModel(makeDesign(fixed, {randomIntercepts("herd", data.labels("herd"))}));
}

BinomialMixedModel countModel(const GoldenData& data, bool crossed) {
  FixedEffects fixed(800);
  fixed.addIntercept();
  fixed.addNumber("view", data.numbers("view"));
  fixed.addNumber("duration", data.numbers("duration"));
  RandomTerm subjects = randomIntercepts("subject", data.labels("subject"));
  if (!crossed) {
    return BinomialMixedModel(makeDesign(fixed, {subjects}));
  }
  addSlope(subjects, "view", fixed);
  return BinomialMixedModel(makeDesign(fixed, {subjects, randomIntercepts("item", data.labels("item"))}));
}

BinomialResponse countResponse(const GoldenData& data) {
  return {data.vector("y"), Eigen::VectorXd::Ones(800)};
}

/// Tolerances: as promised; glmer's own search moves coefficients by a few millionths, and standard errors of either
/// come from differences.
void expectGolden(const BinomialMixedModel& model, const BinomialResponse& response, const nlohmann::json& golden) {
  const Estimable<BinomialMixedFit> fit = model.fit(response, golden.at("points").get<int>());
  ASSERT_TRUE(fit) << fit.reason();
  EXPECT_TRUE(fit->convergence.converged) << fit->convergence.reason;
  EXPECT_NEAR(fit->deviance, golden.at("minusTwoLogLikelihood").get<double>(), 1e-6);
  const std::vector<double> coefficients = numbersOf(golden.at("coefficients"));
  const std::vector<double> standardErrors = numbersOf(golden.at("standardErrors"));
  ASSERT_EQ(fit->coefficients.size(), static_cast<Eigen::Index>(coefficients.size()));
  for (size_t i = 0; i < coefficients.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(fit->coefficients[index] / coefficients[i], 1, 1e-5) << fit->names[i];
    EXPECT_NEAR(fit->standardErrors[index] / standardErrors[i], 1, 2e-4) << fit->names[i];
  }
  const std::vector<double> theta = numbersOf(golden.at("theta"));
  for (size_t i = 0; i < theta.size(); ++i) {
    EXPECT_NEAR(fit->theta[static_cast<Eigen::Index>(i)], theta[i], 1e-5) << "theta " << i;
  }
  const std::vector<double> effects = numbersOf(golden.at("firstEffects"));
  for (size_t i = 0; i < effects.size(); ++i) {
    EXPECT_NEAR(fit->random[0].effects(static_cast<Eigen::Index>(i), 0), effects[i], 1e-4);
  }
}

TEST(BinomialMixedModel, CbppIsThatOfGlmer) {
  const GoldenData data("cbpp");
  const BinomialMixedModel model = cbppModel(data);
  const BinomialResponse response{data.vector("incidence"), data.vector("size")};
  expectGolden(model, response, data.model("laplace"));
  EXPECT_NEAR(model.fit(response)->deviance, 184.0527, 1e-4 + 5e-5);  // as published, to four digits
  expectGolden(model, response, data.model("quadrature9"));
  expectGolden(model, response, data.model("quadrature25"));
}

TEST(BinomialMixedModel, SubjectsByItemsAreThoseOfGlmer) {
  const GoldenData data("count");
  expectGolden(countModel(data, true), countResponse(data), data.model("laplace"));
  expectGolden(countModel(data, false), countResponse(data), data.model("subjects"));
}

}  // namespace
}  // namespace ocelli
