#include "analysis/inference/accelerated_failure_time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

void expectFit(const SurvivalData& data, const std::string& name) {
  const auto fit = fitLogNormal(data);
  ASSERT_TRUE(fit) << fit.reason();
  std::vector<double> coefficients = {fit->intercept.value}, errors = {fit->intercept.standardError}, covariance;
  for (const TimeRatioTerm& term : fit->terms) {
    coefficients.push_back(term.logTimeRatio.value);
    errors.push_back(term.logTimeRatio.standardError);
    EXPECT_DOUBLE_EQ(term.timeRatio.upper, std::exp(term.logTimeRatio.upper));
  }
  coefficients.push_back(fit->logSigma.value);
  errors.push_back(fit->logSigma.standardError);
  for (const std::vector<double>& row : fit->covariance) {
    covariance.insert(covariance.end(), row.begin(), row.end());
  }
  expectGolden(coefficients, name + "/coefficients", kFitted);
  expectGolden(errors, name + "/errors", kFitted);
  expectGolden(covariance, name + "/covariance", kFitted);
  expectGolden({fit->logLikelihood}, name + "/likelihood", kClosedForm);
}

TEST(LogNormal, IsSurvregOnLung) {
  SurvivalData data = goldenData("lung", {"age", "sex", "ph.ecog"});
  expectFit(data, "aft/lung");
  data.clusters = goldenClusters("lung");
  expectFit(data, "aft/lung_clustered");
  EXPECT_NEAR(fitLogNormal(data)->terms[1].modelStandardError, golden("aft/lung_clustered/model_errors")[2], 1e-7);
}

TEST(LogNormal, IsSurvregOnTrialsOfSubjects) {
  SurvivalData data = goldenData("find", {"view"});
  expectFit({data.times, {}, {}, {}}, "aft/intercept");
  data.clusters = goldenClusters("find");
  expectFit(data, "aft/find");
}

TEST(LogNormal, IsLeastSquaresWithoutCensoring) {
  // Two groups: the ratio is that of the geometric means.
  SurvivalData data;
  data.times = {{10, true}, {20, true}, {5, true}, {16, true}};
  data.covariates = {{"view", {0, 0, 1, 1}}};
  EXPECT_NEAR(fitLogNormal(data)->terms[0].timeRatio.value, std::sqrt(5.0 * 16) / std::sqrt(10.0 * 20), 1e-12);
}

std::string reasonFor(const SurvivalData& data) {
  const auto fit = fitLogNormal(data);
  EXPECT_FALSE(fit);
  return fit ? "" : fit.reason();
}

TEST(LogNormal, SaysWhatItLacks) {
  SurvivalData data;
  EXPECT_EQ(reasonFor(data), "there are no trials");
  data.times = {{60, false}, {60, false}};
  EXPECT_EQ(reasonFor(data), "none of 2 trials ended by itself");
  data.times = {{10, true}, {0, true}};
  EXPECT_EQ(reasonFor(data), "a trial took 0 s, which has no logarithm");
  data.times = {{10, true}, {10, true}, {10, true}};
  EXPECT_EQ(reasonFor(data), "the covariates tell the times exactly, so there is no spread to compare with");
  data.times = {{10, true}, {20, true}, {60, false}, {60, false}};
  data.covariates = {{"view", {1, 1, 1, 1}}};
  EXPECT_EQ(reasonFor(data), "'view' is the same in all trials");
  data.covariates = {{"view", {0, 1, 0, 1}}, {"same", {1, 3, 1, 3}}};
  EXPECT_THAT(reasonFor(data), testing::HasSubstr("follows from the other covariates"));
  data.covariates = {{"view", {0, 0, 1, 1}}};
  EXPECT_THAT(reasonFor(data), testing::HasSubstr("the likelihood grows without bound"));
  data.covariates = {{"view", {0, 1, 1, 0}}};
  data.clusters = {1, 1, 2, 2};
  EXPECT_EQ(reasonFor(data), "2 subjects are too few for robust errors of 2 coefficients");
  data.strata = {1, 1, 1, 1};
  EXPECT_THROW(fitLogNormal(data), InputError);
}

}  // namespace
}  // namespace ocelli::test
