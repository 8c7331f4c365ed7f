#include "analysis/inference/wilcoxon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> minus(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (size_t i = 0; i < a.size(); ++i) {
    differences.push_back(a[i] - b[i]);
  }
  return differences;
}

std::vector<double> resultOf(double statistic, const Estimate& estimate, bool all) {
  std::vector<double> numbers = {statistic, estimate.pValue};
  if (all) {
    numbers.insert(numbers.end(), {estimate.value, estimate.lower, estimate.upper});
  }
  return numbers;
}

TEST(SignedRank, IsWilcoxTest) {
  const std::vector<double> differences = minus(golden("sample/second"), golden("sample/first"));
  const SignedRankTest exact = *signedRankTest(differences);
  EXPECT_TRUE(exact.exact);
  expectGolden(resultOf(exact.positiveRanks, exact.center, true), "wilcoxon/signed", kClosedForm);
  const SignedRankTest ninety = *signedRankTest(differences, 0.9);
  expectGolden({ninety.center.lower, ninety.center.upper}, "wilcoxon/signed_90", kClosedForm);
  const SignedRankTest rough = *signedRankTest(minus(golden("sample/rough_second"), golden("sample/rough_first")));
  EXPECT_FALSE(rough.exact);
  EXPECT_GT(rough.zeros, 0u);
  expectGolden(resultOf(rough.positiveRanks, rough.center, false), "wilcoxon/signed_rough", kClosedForm);
  const SignedRankTest many = *signedRankTest(golden("sample/many"));
  EXPECT_FALSE(many.exact);
  expectGolden(resultOf(many.positiveRanks, many.center, true), "wilcoxon/signed_many", kClosedForm);
}

TEST(RankSum, IsWilcoxTest) {
  const RankSumTest exact = *rankSumTest(golden("sample/first"), golden("sample/other"));
  EXPECT_TRUE(exact.exact);
  expectGolden(resultOf(exact.statistic, exact.shift, true), "wilcoxon/sum", kClosedForm);
  const RankSumTest rough = *rankSumTest(golden("sample/rough_first"), golden("sample/rough_other"));
  EXPECT_FALSE(rough.exact);
  expectGolden(resultOf(rough.statistic, rough.shift, false), "wilcoxon/sum_rough", kClosedForm);
  std::vector<double> both = golden("sample/first");
  both.insert(both.end(), golden("sample/other").begin(), golden("sample/other").end());
  for (double& value : both) {
    value -= 10;
  }
  const RankSumTest many = *rankSumTest(both, golden("sample/many"));
  EXPECT_FALSE(many.exact);
  expectGolden(resultOf(many.statistic, many.shift, false), "wilcoxon/sum_many", kClosedForm);
}

TEST(SignedRank, GivesNoIntervalWhereThereAreTooFewValues) {
  const SignedRankTest five = *signedRankTest({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(five.center.pValue, 2.0 / 32);
  EXPECT_DOUBLE_EQ(five.center.value, 3);
  EXPECT_TRUE(std::isnan(five.center.lower));
  EXPECT_FALSE(std::isnan(signedRankTest({1, 2, 3, 4, 5, 6})->center.lower));
}

TEST(RankSum, CountsEveryArrangement) {
  // Of 2 and 2 values, the 6 arrangements have the sums 0, 1, 2, 2, 3, 4.
  EXPECT_NEAR(rankSumTest({1, 2}, {3, 4})->shift.pValue, 2.0 / 6, 1e-15);
  EXPECT_NEAR(rankSumTest({1, 3}, {2, 4})->shift.pValue, 4.0 / 6, 1e-15);
  EXPECT_NEAR(rankSumTest({1, 4}, {2, 3})->shift.pValue, 1, 1e-15);
}

TEST(Wilcoxon, SaysWhatItLacks) {
  EXPECT_EQ(signedRankTest({}).reason(), "there are no values");
  EXPECT_EQ(signedRankTest({0, 0}).reason(), "all values are 0");
  EXPECT_EQ(rankSumTest({}, {1}).reason(), "a group has no values");
  EXPECT_EQ(rankSumTest({1, 1}, {1}).reason(), "all values are the same");
  EXPECT_THROW(signedRankTest(std::vector<double>(10000, 1)), InputError);
  EXPECT_THROW(rankSumTest(std::vector<double>(5000, 1), std::vector<double>(5000, 2)), InputError);
}

}  // namespace
}  // namespace ocelli::test
