#include "analysis/inference/log_rank.h"

#include <gtest/gtest.h>

#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> resultOf(const LogRankTest& test) {
  return {test.chiSquared.statistic, test.chiSquared.degreesOfFreedom};
}

TEST(LogRank, IsSurvdiffOfTwoGroups) {
  const LogRankTest test = *logRankTest(goldenTimes("lung"), goldenLabels("lung/sex"));
  expectGolden(resultOf(test), "logrank/lung", kClosedForm);
  expectGolden({test.groups[0].expected, test.groups[1].expected}, "logrank/lung_expected", kClosedForm);
  EXPECT_EQ(test.groups[0].label, 1);
  EXPECT_NEAR(test.chiSquared.pValue, 0.00166, 1e-5);
}

TEST(LogRank, IsSurvdiffOfManyGroupsAndOfStrata) {
  const std::vector<int> types = goldenLabels("veteran/type");
  expectGolden(resultOf(*logRankTest(goldenTimes("veteran"), types)), "logrank/veteran", kClosedForm);
  expectGolden(resultOf(*logRankTest(goldenTimes("veteran"), goldenLabels("veteran/trt"), types)), "logrank/strata",
               kClosedForm);
}

TEST(LogRank, SaysWhatItLacks) {
  EXPECT_EQ(logRankTest({{1, true}, {2, true}}, {5, 5}).reason(), "there is only one group");
  EXPECT_EQ(logRankTest({{1, false}, {2, false}}, {1, 2}).reason(),
            "a group was never at risk together with others when an event came, or there was none");
  EXPECT_EQ(logRankTest({{1, false}, {2, true}}, {1, 2}).reason(),
            "a group was never at risk together with others when an event came, or there was none");
}

}  // namespace
}  // namespace ocelli::test
