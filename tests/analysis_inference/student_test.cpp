#include "analysis/inference/student.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> numbersOf(const Estimate& e) {
  return {e.value, e.lower, e.upper, e.statistic, e.degreesOfFreedom, e.pValue};
}

TEST(Student, isTheTTestOfR) {
  expectGolden(numbersOf(*studentMean(golden("sample/first"))), "student/mean", kClosedForm);
  expectGolden(numbersOf(*studentMean(golden("sample/first"), 0.8)), "student/mean80", kClosedForm);
  expectGolden(numbersOf(*welchDifference(golden("sample/first"), golden("sample/other"))), "student/welch",
               kClosedForm);
}

// 1, 2, 6: mean 3, variance 7, so the error is sqrt(7/3) = 1.527525; t of 97.5 % with 2 degrees is 4.302653.
TEST(Student, aMeanByHand) {
  const Estimate mean = *studentMean({1, 2, 6});
  EXPECT_EQ(mean.value, 3);
  EXPECT_NEAR(mean.upper, 3 + 4.302653 * 1.527525, 1e-5);
  EXPECT_NEAR(mean.lower, 3 - 4.302653 * 1.527525, 1e-5);
}

TEST(Student, saysWhatItLacks) {
  EXPECT_EQ(studentMean({}).reason(), "there are 0 values, and 2 are needed");
  EXPECT_EQ(studentMean({1}).reason(), "there are 1 values, and 2 are needed");
  EXPECT_EQ(studentMean({0.1, 0.1, 0.1}).reason(), "all 3 values are the same");
  EXPECT_EQ(welchDifference({1, 2}, {1}).reason(), "the groups have 2 and 1 values, and 2 in each are needed");
  EXPECT_EQ(welchDifference({1, 1}, {2, 2}).reason(), "in each group all values are the same");
  EXPECT_TRUE(welchDifference({1, 1}, {2, 3}));
  EXPECT_THROW(studentMean({1, kNotKnown}), InputError);
  EXPECT_THROW(welchDifference({1, 2}, {1, kNotKnown}), InputError);
}

}  // namespace
}  // namespace ocelli::test
