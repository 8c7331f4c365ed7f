#include "analysis/inference/equivalence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> numbersOf(const EquivalenceTest& test) {
  return {test.difference.value, test.difference.standardError,
          test.difference.lower, test.difference.upper,
          test.pAboveLower,      test.pBelowUpper};
}

std::vector<double> pairDifferences() {
  std::vector<double> differences;
  for (size_t i = 0; i < golden("sample/first").size(); ++i) {
    differences.push_back(golden("sample/second")[i] - golden("sample/first")[i]);
  }
  return differences;
}

TEST(Equivalence, IsTwoTTestsOfR) {
  const EquivalenceTest paired = *equivalenceOfPairedMeans(pairDifferences(), {-2, 2});
  expectGolden(numbersOf(paired), "equivalence/paired", kClosedForm);
  expectGolden({paired.pAboveLower, paired.pBelowUpper}, "equivalence/paired_t", kClosedForm);
  const EquivalenceTest welch = *equivalenceOfMeans(golden("sample/first"), golden("sample/other"), {-1.5, 1.5});
  std::vector<double> numbers = numbersOf(welch);
  numbers.push_back(welch.difference.degreesOfFreedom);
  expectGolden(numbers, "equivalence/welch", kClosedForm);
  expectGolden({welch.pAboveLower, welch.pBelowUpper}, "equivalence/welch_t", kClosedForm);
  EXPECT_TRUE(paired.equivalent);
  EXPECT_FALSE(welch.equivalent);
}

TEST(Equivalence, OfSharesIsThatOfTheirNormalDifference) {
  expectGolden(numbersOf(*equivalenceOfShares({150, 225}, {157, 225}, {-0.1, 0.1})), "equivalence/shares", kClosedForm);
  expectGolden(numbersOf(*equivalenceOfPairedShares({40, 6, 25, 19, 0}, {-0.1, 0.1})), "equivalence/paired_shares",
               kClosedForm);
}

TEST(Equivalence, HoldsExactlyWhereTheIntervalLiesWithinTheBounds) {
  for (const double difference : {-0.9, -0.3, 0.0, 0.2, 0.7}) {
    for (const double error : {0.05, 0.2, 0.4, 0.7}) {
      for (const double df : {4.0, 30.0, static_cast<double>(INFINITY)}) {
        const EquivalenceTest test = equivalenceOf(difference, error, df, {-1, 1});
        EXPECT_EQ(test.equivalent, test.difference.lower > -1 && test.difference.upper < 1);
      }
    }
  }
}

TEST(Equivalence, SaysWhatItLacks) {
  const EquivalenceBounds bounds = {-1, 1};
  EXPECT_EQ(equivalenceOfPairedMeans({1}, bounds).reason(), "there are 1 differences, and 2 are needed");
  EXPECT_EQ(equivalenceOfPairedMeans({0.1, 0.1, 0.1}, bounds).reason(), "all differences are the same");
  EXPECT_EQ(equivalenceOfMeans({1, 2}, {3}, bounds).reason(),
            "the groups have 2 and 1 values, and 2 in each are needed");
  EXPECT_EQ(equivalenceOfMeans({1, 1}, {3, 3}, bounds).reason(), "in each group all values are the same");
  EXPECT_EQ(equivalenceOfShares({0, 5}, {6, 6}, bounds).reason(), "in each group all trials have the same outcome");
  EXPECT_EQ(equivalenceOfShares({0, 0}, {3, 6}, bounds).reason(), "a group has no trials");
  EXPECT_FALSE(equivalenceOfPairedShares({5, 0, 0, 5, 0}, bounds));
  EXPECT_FALSE(equivalenceOfPairedShares({0, 0, 0, 0, 0}, bounds));
  EXPECT_THROW(equivalenceOf(0, 1, 10, {1, -1}), InputError);
}

}  // namespace
}  // namespace ocelli::test
