#include "analysis/inference/cox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

void expectCoxFit(const SurvivalData& data, const std::string& name) {
  const auto fit = fitCox(data);
  ASSERT_TRUE(fit) << fit.reason();
  std::vector<double> coefficients, errors, modelErrors, covariance;
  for (const CoxTerm& term : fit->terms) {
    coefficients.push_back(term.logHazardRatio.value);
    errors.push_back(term.logHazardRatio.standardError);
    modelErrors.push_back(term.modelStandardError);
    EXPECT_DOUBLE_EQ(term.hazardRatio.lower,
                     std::exp(term.logHazardRatio.value - 1.959963984540054 * term.logHazardRatio.standardError));
  }
  for (const std::vector<double>& row : fit->covariance) {
    covariance.insert(covariance.end(), row.begin(), row.end());
  }
  expectGolden(coefficients, name + "/coefficients", kFitted);
  expectGolden(errors, name + "/errors", kFitted);
  expectGolden(covariance, name + "/covariance", kFitted);
  if (!data.clusters.empty()) {
    expectGolden(modelErrors, name + "/model_errors", kFitted);
  }
  expectGolden({fit->nullLogLikelihood, fit->logLikelihood}, name + "/likelihood", kClosedForm);
  expectGolden({fit->likelihoodRatio.statistic, fit->wald.statistic}, name + "/tests", kFitted);
  for (const auto& [scale, suffix] :
       {std::pair(TimeScale::kKaplanMeier, "/zph_km"), std::pair(TimeScale::kSeconds, "/zph_identity")}) {
    const auto test = testProportionality(data, scale);
    ASSERT_TRUE(test) << test.reason();
    std::vector<double> statistics;
    for (const Estimate& term : test->terms) {
      statistics.push_back(term.statistic);
    }
    statistics.push_back(test->all.statistic);
    expectGolden(statistics, name + suffix, kFitted);
  }
}

TEST(Cox, IsCoxphOnLung) {
  SurvivalData data = goldenData("lung", {"age", "sex", "ph.ecog"});
  expectCoxFit(data, "cox/lung");
  data.clusters = goldenClusters("lung");
  expectCoxFit(data, "cox/lung_clustered");
}

TEST(Cox, IsCoxphWithStrata) {
  SurvivalData data = goldenData("veteran", {"trt", "karno"});
  data.strata = goldenLabels("veteran/type");
  expectCoxFit(data, "cox/veteran_strata");
}

TEST(Cox, IsCoxphWithManyTiesClustersAndStrata) {
  SurvivalData data = goldenData("find", {"view"});
  data.clusters = goldenClusters("find");
  expectCoxFit(data, "cox/find");
  data.strata = goldenLabels("find/case");
  expectCoxFit(data, "cox/find_strata");
}

TEST(Cox, DoesNotDependOnUnits) {
  SurvivalData data = goldenData("lung", {"age"});
  const double perYear = fitCox(data)->terms[0].logHazardRatio.value;
  for (double& age : data.covariates[0].values) {
    age = 1e6 + age * 1e-3;
  }
  EXPECT_NEAR(fitCox(data)->terms[0].logHazardRatio.value, perYear * 1000, 1e-5);  // of 1e6 + 0.06, 10 digits are left
}

std::string reasonForCox(const SurvivalData& data) {
  const auto fit = fitCox(data);
  EXPECT_FALSE(fit);
  EXPECT_FALSE(testProportionality(data) && data.clusters.empty());
  return fit ? "" : fit.reason();
}

TEST(Cox, SaysWhatItLacks) {
  SurvivalData data;
  EXPECT_EQ(reasonForCox(data), "none of 0 trials ended by itself");
  data.times = {{10, true}, {20, true}, {30, true}, {40, false}};
  EXPECT_EQ(reasonForCox(data), "there is no covariate");
  data.covariates = {{"view", {1, 1, 1, 1}}};
  EXPECT_EQ(reasonForCox(data), "'view' is the same in all trials");
  data.covariates = {{"view", {0, 1, 0, 1}}, {"same", {1, 3, 1, 3}}};
  EXPECT_THAT(reasonForCox(data), testing::HasSubstr("follows from the other covariates"));
  data.covariates = {{"view", {0, 0, 0, 1}}};
  EXPECT_THAT(reasonForCox(data), testing::HasSubstr("the likelihood grows without bound in 'view'"));
  data.covariates = {{"view", {1, 1, 0, 0}}};
  EXPECT_THAT(reasonForCox(data), testing::HasSubstr("the likelihood grows without bound in 'view'"));
  data.covariates = {{"view", {0, 1, 0, 1}}};
  data.times = {{7, true}, {7, true}, {7, true}, {7, true}};
  EXPECT_EQ(reasonForCox(data), "all 4 trials ended at the same moment");
  data.times = {{10, true}, {20, true}, {30, true}, {40, false}};
  data.strata = {1, 2, 3, 4};
  EXPECT_EQ(reasonForCox(data), "'view' does not vary among trials that can be compared");
  data.strata = {};
  data.clusters = {1, 1, 1, 1};
  EXPECT_EQ(reasonForCox(data), "1 subject is too few for robust errors of 1 coefficient");
  data.clusters = {1};
  EXPECT_THROW(fitCox(data), InputError);
}

}  // namespace
}  // namespace ocelli::test
