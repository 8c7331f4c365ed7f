#include "analysis/inference/effect_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

/// R warns that its noncentral t distribution is not exact to all digits.
constexpr double kNoncentral = 1e-8;

std::vector<double> intervalOf(const Estimate& estimate) {
  return {estimate.value, estimate.lower, estimate.upper};
}

TEST(EffectSize, HasCohensDOfPairsAndGroups) {
  const PairedEffect paired = *pairedEffect(golden("sample/first"), golden("sample/second"));
  std::vector<double> numbers = intervalOf(paired.dz);
  numbers.insert(numbers.end(), {paired.dav.value, paired.correctedDz.value, paired.correctedDav.value});
  expectGolden(numbers, "effect/paired", kNoncentral);
  EXPECT_NEAR(paired.dav.lower / paired.dz.lower, paired.dav.value / paired.dz.value, 1e-12);
  const GroupEffect groups = *groupEffect(golden("sample/first"), golden("sample/other"));
  numbers = intervalOf(groups.d);
  numbers.push_back(groups.correctedD.value);
  expectGolden(numbers, "effect/groups", kNoncentral);
}

TEST(EffectSize, HasRatiosOfBinomialModels) {
  expectGolden(intervalOf(*oddsRatio({12, 40}, {30, 45})), "effect/odds", kFitted);
  expectGolden(intervalOf(*riskRatio({12, 40}, {30, 45})), "effect/risk", kFitted);
  expectGolden(intervalOf(*riskDifference({12, 40}, {30, 45})), "effect/difference", kClosedForm);
  // A share of 1 has an interval too.
  const Estimate certain = *riskDifference({0, 20}, {20, 20});
  EXPECT_EQ(certain.value, 1);
  EXPECT_LT(certain.lower, 0.9);
  EXPECT_EQ(certain.upper, 1);
}

TEST(EffectSize, HasCliffsDeltaAndRankBiserial) {
  const auto numbers = [](const Estimate& estimate) {
    return std::vector<double>{estimate.value, estimate.standardError, estimate.lower, estimate.upper};
  };
  expectGolden(numbers(*cliffsDelta(golden("sample/first"), golden("sample/other"))), "effect/cliff", kClosedForm);
  expectGolden(numbers(*cliffsDelta(golden("sample/rough_first"), golden("sample/rough_other"))), "effect/cliff_rough",
               kClosedForm);
  std::vector<double> differences;
  for (size_t i = 0; i < golden("sample/first").size(); ++i) {
    differences.push_back(golden("sample/second")[i] - golden("sample/first")[i]);
  }
  expectGolden(intervalOf(*matchedRankBiserial(differences)), "effect/biserial", kClosedForm);
}

TEST(EffectSize, SaysWhatItLacks) {
  EXPECT_EQ(pairedEffect({1}, {2}).reason(), "there are 1 pairs, and 2 are needed");
  EXPECT_EQ(pairedEffect({1, 2, 3}, {2, 3, 4}).reason(), "all differences are the same");
  EXPECT_THROW(pairedEffect({1, 2}, {1}), InputError);
  EXPECT_TRUE(std::isnan(pairedEffect({1, 2}, {2, 4})->correctedDz.value));
  EXPECT_EQ(groupEffect({1, 1}, {2, 2}).reason(), "in each group all values are the same");
  EXPECT_EQ(groupEffect({1}, {2, 2}).reason(), "the groups have 1 and 2 values, and 2 in each are needed");
  EXPECT_EQ(oddsRatio({3, 3}, {2, 3}).reason(), "in one group all trials have the same outcome");
  EXPECT_EQ(riskRatio({0, 3}, {2, 3}).reason(), "one group has no success");
  EXPECT_EQ(riskRatio({3, 3}, {3, 3}).reason(), "all trials of both groups are successes");
  EXPECT_EQ(riskDifference({0, 0}, {2, 3}).reason(), "a group has no trials");
  EXPECT_FALSE(cliffsDelta({1}, {2, 3}));
  EXPECT_TRUE(std::isnan(cliffsDelta({1, 2}, {3, 4})->lower));
  EXPECT_EQ(matchedRankBiserial({0, 0}).reason(), "all values are 0");
  EXPECT_TRUE(std::isnan(matchedRankBiserial({1, 2})->upper));
}

}  // namespace
}  // namespace ocelli::test
