#include "analysis/inference/ordinal.h"

#include <gtest/gtest.h>

#include "analysis/inference/proportional_odds.h"
#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

TEST(Ordinal, CountsAnswers) {
  const OrdinalDistribution answers = *ordinalDistribution({5, 5, 4, 3, 1, 5});
  EXPECT_EQ(answers.counts, (std::vector<int>{1, 0, 1, 1, 3}));
  EXPECT_EQ(answers.belowMiddle, 1);
  EXPECT_EQ(answers.atMiddle, 1);
  EXPECT_EQ(answers.aboveMiddle, 4);
  EXPECT_DOUBLE_EQ(answers.mean, 23.0 / 6);
  EXPECT_DOUBLE_EQ(answers.median, 4.5);
  EXPECT_DOUBLE_EQ(answers.shares[4].value, 0.5);
}

TEST(Ordinal, TestsAgainstTheMiddle) {
  // Of 5 that lean to a side, 4 lean up.
  const MiddleTest test = *testAgainstMiddle({5, 5, 4, 3, 1, 5});
  EXPECT_EQ(test.sign.share.successes, 4);
  EXPECT_EQ(test.sign.share.trials, 5);
  EXPECT_DOUBLE_EQ(test.sign.clopperPearson.pValue, 12.0 / 32);
  EXPECT_EQ(test.signedRank.zeros, 1u);
  // Ranks of 2, 2, 1, -2, 2: 3.5 of each 2, 1 of the 1.
  EXPECT_DOUBLE_EQ(test.signedRank.positiveRanks, 11.5);
}

TEST(Ordinal, HasAMiddleBetweenTheAnswersOfAnEvenScale) {
  const OrdinalDistribution answers = *ordinalDistribution({1, 3, 4, 4}, 4);
  EXPECT_EQ(answers.belowMiddle, 1);
  EXPECT_EQ(answers.atMiddle, 0);
  EXPECT_EQ(answers.aboveMiddle, 3);
  // -1.5, 0.5, 1.5 and 1.5 from the middle: ranks of the sizes are 3, 1, 3 and 3.
  const MiddleTest test = *testAgainstMiddle({1, 3, 4, 4}, 4);
  EXPECT_EQ(test.signedRank.zeros, 0u);
  EXPECT_DOUBLE_EQ(test.signedRank.positiveRanks, 7);
  // The median of the means of all pairs: -1.5, -0.5, 0, 0, 0.5, 1, 1, 1.5, 1.5, 1.5.
  EXPECT_DOUBLE_EQ(test.signedRank.center.value, 0.75);
}

TEST(Ordinal, SaysWhatItLacks) {
  EXPECT_EQ(ordinalDistribution({}).reason(), "there are no answers");
  EXPECT_EQ(testAgainstMiddle({3, 3, 3}).reason(), "all answers are at the middle");
  EXPECT_TRUE(testAgainstMiddle({5, 5, 5}));
  EXPECT_THROW(ordinalDistribution({6}), InputError);
  EXPECT_THROW(ordinalDistribution({1}, 1), InputError);
  EXPECT_THROW(ordinalDistribution({5}, 4), InputError);
}

TEST(ProportionalOdds, IsPolr) {
  const auto fit = fitProportionalOdds(goldenLabels("odds/y"), {{"x", golden("odds/x")}, {"age", golden("odds/age")}});
  ASSERT_TRUE(fit) << fit.reason();
  std::vector<double> coefficients, errors;
  for (const OddsTerm& term : fit->terms) {
    coefficients.push_back(term.logOddsRatio.value);
    errors.push_back(term.logOddsRatio.standardError);
  }
  for (const Estimate& threshold : fit->thresholds) {
    coefficients.push_back(threshold.value);
    errors.push_back(threshold.standardError);
  }
  expectGolden(coefficients, "odds/coefficients", kFitted);
  expectGolden(errors, "odds/errors", 1e-6);  // of R's numerical second derivatives
  expectGolden({fit->logLikelihood, fit->logLikelihood - fit->likelihoodRatio.statistic / 2}, "odds/likelihood", 1e-7);
  EXPECT_EQ(fit->answers.size(), 5u);
}

TEST(ProportionalOdds, SaysWhatItLacks) {
  const std::vector<Covariate> view = {{"view", {0, 0, 1, 1}}};
  EXPECT_EQ(fitProportionalOdds({4, 4, 4, 4}, view).reason(), "all answers are the same");
  EXPECT_EQ(fitProportionalOdds({1, 2, 4, 5}, view).reason(),
            "the likelihood grows without bound in 'view', as where one group has all the higher answers");
  EXPECT_EQ(fitProportionalOdds({1, 2, 4, 5}, {{"view", {1, 1, 1, 1}}}).reason(), "'view' is the same in all trials");
  EXPECT_EQ(fitProportionalOdds({1, 2}, {}).reason(), "there is no covariate");
  EXPECT_TRUE(fitProportionalOdds({1, 4, 2, 5}, view));
}

}  // namespace
}  // namespace ocelli::test
