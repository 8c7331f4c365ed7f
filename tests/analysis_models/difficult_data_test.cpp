// Data that give no estimate, or one with a reservation: said, never made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_models/sample_models.h"

namespace ocelli {
namespace {

using Eigen::VectorXd;
using testing::HasSubstr;

const SampleSize kSize{10, 8, 2};

VectorXd linearResponse(const LinearMixedModel& model, uint64_t seed = 4) {
  RandomNumbers numbers(seed);
  return model.simulate(sampleLinearTruth(), numbers);
}

BinomialResponse answers(const BinomialMixedModel& model, uint64_t seed = 4) {
  RandomNumbers numbers(seed);
  return model.simulate(sampleBinomialTruth(), VectorXd::Ones(model.design().rows()), numbers);
}

void expectAllFinite(const MixedModelFit& fit) {
  EXPECT_TRUE(fit.coefficients.allFinite());
  EXPECT_TRUE(fit.standardErrors.allFinite());
  EXPECT_TRUE(fit.theta.allFinite());
  EXPECT_TRUE(fit.fitted.allFinite());
  EXPECT_TRUE(std::isfinite(fit.deviance));
}

TEST(DifficultLinearData, EqualResponses) {
  const LinearMixedModel model(sampleDesign(kSize));
  EXPECT_EQ(model.fit(VectorXd::Constant(160, 3)).reason(), "all responses are equal");
}

TEST(DifficultLinearData, ResponsesThatTheEffectsReproduce) {
  const Design design = sampleDesign(kSize);
  const LinearMixedModel model(design);
  EXPECT_THAT(model.fit(design.fixed * VectorXd::Ones(4)).reason(), HasSubstr("exactly"));
  const Eigen::Map<const Eigen::VectorXi> subjects(design.random[0].levelOfRow.data(), design.rows());
  EXPECT_THAT(model.fit(subjects.cast<double>()).reason(), HasSubstr("exactly"));
}

TEST(DifficultLinearData, NoRowsOneSubjectAndOneRowEach) {
  const auto reasonOf = [](const SampleSize& size) {
    const LinearMixedModel model(sampleDesign(size));
    return model.fit(VectorXd::LinSpaced(model.design().rows(), 0, 1)).reason();
  };
  EXPECT_EQ(reasonOf({0, 0, 0}), "there are no rows");
  EXPECT_THAT(reasonOf({1, 20, 1}), HasSubstr("there is only one subject"));
  EXPECT_THAT(reasonOf({8, 1, 1}), HasSubstr("cannot be told"));
}

TEST(DifficultLinearData, ValuesThatAreNotFinite) {
  const LinearMixedModel model(sampleDesign(kSize));
  VectorXd response = linearResponse(model);
  response[3] = std::nan("");
  EXPECT_THROW(model.fit(response), InputError);
  EXPECT_THROW(model.fit(VectorXd::Ones(3)), InputError);
}

TEST(DifficultLinearData, CollinearPredictorsAreDroppedAndNamed) {
  FixedEffects fixed = sampleFixedEffects(kSize);
  const VectorXd twice = 2 * fixed.columns().col(2);
  fixed.addNumber("twice", {twice.begin(), twice.end()});
  const LinearMixedModel model(makeDesign(fixed, sampleRandomTerms(kSize, fixed)));
  const auto fit = model.fit(linearResponse(model));
  ASSERT_TRUE(fit);
  expectAllFinite(*fit);
  EXPECT_EQ(fit->coefficients.size(), 4);
  EXPECT_EQ(fit->warnings.front(), "twice was dropped: the columns before it determine it");
  EXPECT_EQ(coefficientEstimate(*fit, "twice").reason(), fit->warnings.front());
  EXPECT_THAT(coefficientEstimate(*fit, "other").reason(), HasSubstr("no coefficient"));
}

// Columns in other units give the same model: rounding apart, 1e-6 of each number.
TEST(DifficultLinearData, HugeScalesOfPredictorsAndResponses) {
  const auto fitWith = [](double sessionScale, double responseScale) {
    FixedEffects fixed = sampleFixedEffects(kSize, sessionScale);
    std::vector<RandomTerm> random = sampleRandomTerms(kSize, fixed);
    addSlope(random[1], "session", fixed);
    const LinearMixedModel plain(sampleDesign(kSize));
    const LinearMixedModel model(makeDesign(fixed, random));
    return model.fit(responseScale * linearResponse(plain), false);
  };
  const auto plain = fitWith(1, 1);
  const auto scaled = fitWith(1e12, 1e-9);
  ASSERT_TRUE(plain && scaled);
  EXPECT_TRUE(scaled->convergence.converged) << scaled->convergence.reason;
  EXPECT_NEAR(scaled->deviance, plain->deviance + 2 * 160 * std::log(1e-9), 1e-6);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double unit = (i == 3 ? 1e-12 : 1) * 1e-9;
    EXPECT_NEAR(scaled->coefficients[i] / unit, plain->coefficients[i], 1e-6);
    EXPECT_NEAR(scaled->standardErrors[i] / unit, plain->standardErrors[i], 1e-6);
    const Estimate a = contrastEstimate(*plain, VectorXd::Unit(4, i));
    const Estimate b = contrastEstimate(*scaled, VectorXd::Unit(4, i));
    EXPECT_NEAR(b.degreesOfFreedom / a.degreesOfFreedom, 1, 1e-3);
  }
  EXPECT_NEAR(scaled->random[1].standardDeviations[1] / 1e-21, plain->random[1].standardDeviations[1], 1e-5);
}

TEST(DifficultLinearData, NoVarianceOfASlopeIsSingular) {
  // The slope's variance is estimated as 0 in some studies without one.
  const LinearMixedModel model(sampleDesign(kSize));
  LinearMixedFit truth = sampleLinearTruth();
  truth.theta << 0.8, 0, 0, 0.6;
  int singular = 0;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    RandomNumbers numbers(seed);
    const auto fit = model.fit(model.simulate(truth, numbers));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->convergence.converged) << seed << ": " << fit->convergence.reason;
    expectAllFinite(*fit);
    EXPECT_EQ(fit->singular, !fit->boundary.empty());
    singular += fit->singular ? 1 : 0;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double df = contrastEstimate(*fit, VectorXd::Unit(4, i)).degreesOfFreedom;
      EXPECT_TRUE(df > 0 && df < 1000) << seed << ": " << df;
    }
  }
  EXPECT_GT(singular, 5);
  EXPECT_LT(singular, 30);
}

TEST(DifficultBinomialData, EqualResponses) {
  const BinomialMixedModel model(sampleDesign(kSize));
  const VectorXd ones = VectorXd::Ones(160);
  EXPECT_EQ(model.fit({ones, ones}).reason(), "all responses are equal");
  EXPECT_EQ(model.fit({0 * ones, ones}).reason(), "all responses are equal");
}

TEST(DifficultBinomialData, SeparatedAnswersAreNamed) {
  const Design design = sampleDesign(kSize);
  const BinomialMixedModel model(design);
  const Eigen::ArrayXd view = design.fixed.col(1).array();
  const VectorXd ones = VectorXd::Ones(design.rows());
  // All right in the graph view, and nowhere else.
  const auto perfect = model.fit({(view > 0).cast<double>().matrix(), ones});
  ASSERT_FALSE(perfect);
  EXPECT_THAT(perfect.reason(), HasSubstr("view=gc"));
  // All right there, and some elsewhere.
  BinomialResponse response = answers(model);
  response.successes = (view > 0).select(ones, response.successes);
  const auto quasi = model.fit(response);
  ASSERT_FALSE(quasi);
  EXPECT_THAT(quasi.reason(), HasSubstr("view=gc"));
  EXPECT_THAT(quasi.reason(), testing::Not(HasSubstr("session")));
  // One wrong answer there is enough for an estimate.
  for (Eigen::Index row = 0; row < design.rows(); ++row) {
    if (view[row] > 0) {
      response.successes[row] = 0;
      break;
    }
  }
  const auto fit = model.fit(response);
  ASSERT_TRUE(fit) << fit.reason();
  expectAllFinite(*fit);
}

TEST(DifficultBinomialData, SubjectsOfOneKindOfAnswerEach) {
  const SampleSize size{12, 10, 2};
  const Design design = sampleDesign(size);
  const BinomialMixedModel model(makeDesign(sampleFixedEffects(size), {randomIntercepts("subject", [&] {
                                              std::vector<std::string> labels;
                                              for (const int level : design.random[0].levelOfRow) {
                                                labels.push_back(design.random[0].levels[static_cast<size_t>(level)]);
                                              }
                                              return labels;
                                            }())}));
  VectorXd successes(design.rows());
  for (Eigen::Index row = 0; row < design.rows(); ++row) {
    successes[row] = design.random[0].levelOfRow[static_cast<size_t>(row)] % 2;
  }
  const auto fit = model.fit({successes, VectorXd::Ones(design.rows())});
  ASSERT_FALSE(fit) << fit->theta;
  EXPECT_THAT(fit.reason(), HasSubstr("differ without limit"));
}

TEST(DifficultBinomialData, NoVarianceIsSingular) {
  const BinomialMixedModel model(sampleDesign(kSize));
  BinomialMixedFit truth = sampleBinomialTruth();
  truth.theta << 0.3, 0, 0, 0;
  int singular = 0;
  for (uint64_t seed = 0; seed < 15; ++seed) {
    RandomNumbers numbers(seed);
    const auto fit = model.fit(model.simulate(truth, VectorXd::Ones(160), numbers));
    ASSERT_TRUE(fit) << fit.reason();
    EXPECT_TRUE(fit->convergence.converged) << seed << ": " << fit->convergence.reason;
    expectAllFinite(*fit);
    singular += fit->singular ? 1 : 0;
  }
  EXPECT_GT(singular, 5);
}

TEST(DifficultBinomialData, RestrictedLikelihoodIsAsCareful) {
  const BinomialMixedModel model(sampleDesign(kSize));
  BinomialMixedFit truth = sampleBinomialTruth();
  for (uint64_t seed = 0; seed < 10; ++seed) {
    RandomNumbers numbers(seed);
    const BinomialResponse response = model.simulate(truth, VectorXd::Ones(160), numbers);
    const auto fit = model.fitRestricted(response);
    const auto unrestricted = model.fit(response);
    ASSERT_TRUE(fit && unrestricted);
    EXPECT_TRUE(fit->convergence.converged) << seed << ": " << fit->convergence.reason;
    expectAllFinite(*fit);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const Estimate estimate = contrastEstimate(*fit, VectorXd::Unit(4, i));
      EXPECT_GT(estimate.degreesOfFreedom, 1);
      EXPECT_NEAR(estimate.value, unrestricted->coefficients[i], 0.5 * estimate.standardError);
      EXPECT_GT(estimate.standardError, 0.9 * unrestricted->standardErrors[i]);
    }
    EXPECT_FALSE(likelihoodRatio(*fit, *unrestricted));
  }
  const VectorXd ones = VectorXd::Ones(160);
  EXPECT_EQ(model.fitRestricted({ones, ones}).reason(), "all responses are equal");
}

TEST(DifficultBinomialData, ResponsesThatAreNone) {
  const BinomialMixedModel model(sampleDesign(kSize));
  const VectorXd ones = VectorXd::Ones(160);
  EXPECT_THROW(model.fit({2 * ones, ones}), InputError);
  EXPECT_THROW(model.fit({-ones, ones}), InputError);
  EXPECT_THROW(model.fit({0.5 * ones, ones}), InputError);
  EXPECT_THROW(model.fit({0 * ones, 0 * ones}), InputError);
  EXPECT_THROW(model.fit({std::nan("") * ones, ones}), InputError);
  EXPECT_THROW(model.fit({ones.head(3), ones}), InputError);
  EXPECT_THROW(model.fit(answers(model), 9), InputError);
  EXPECT_THROW(model.fit(answers(model), 0), InputError);
}

TEST(DifficultBinomialData, OneTrialOfEachLevel) {
  FixedEffects fixed(6);
  fixed.addIntercept();
  const std::vector<RandomTerm> random = {randomIntercepts("subject", {"a", "b", "c", "d", "e", "f"})};
  const BinomialMixedModel model(makeDesign(fixed, random));
  VectorXd successes(6);
  successes << 1, 0, 1, 0, 0, 1;
  EXPECT_THAT(model.fit({successes, VectorXd::Ones(6)}).reason(), HasSubstr("cannot be told"));
  // Of many trials each it can.
  const auto fit = model.fit({4 * successes + VectorXd::Constant(6, 2), VectorXd::Constant(6, 8)});
  ASSERT_TRUE(fit) << fit.reason();
  expectAllFinite(*fit);
}

}  // namespace
}  // namespace ocelli
