#include "analysis/inference/kaplan_meier.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<double> column(const SurvivalCurve& curve, double (*value)(const SurvivalStep&)) {
  std::vector<double> values;
  for (const SurvivalStep& step : curve.steps) {
    values.push_back(value(step));
  }
  return values;
}

std::vector<double> medianOf(const std::vector<SurvivalTime>& times) {
  const Estimate median = *medianTime(*survivalCurve(times));
  return {median.value, median.lower, median.upper};
}

TEST(KaplanMeier, IsTheCurveOfSurvfitOnLung) {
  const SurvivalCurve curve = *survivalCurve(goldenTimes("lung"));
  const auto expect = [&](double (*value)(const SurvivalStep&), const char* name) {
    expectGolden(column(curve, value), name, kClosedForm);
  };
  expect([](const SurvivalStep& step) { return step.riskSet.seconds; }, "curve/time");
  expect([](const SurvivalStep& step) { return static_cast<double>(step.riskSet.atRisk); }, "curve/risk");
  expect([](const SurvivalStep& step) { return static_cast<double>(step.riskSet.events); }, "curve/events");
  expect([](const SurvivalStep& step) { return step.survival; }, "curve/survival");
  expect([](const SurvivalStep& step) { return step.standardError; }, "curve/error");
  expect([](const SurvivalStep& step) { return step.lower; }, "curve/lower");
  expect([](const SurvivalStep& step) { return step.upper; }, "curve/upper");
}

TEST(KaplanMeier, HasTheMediansOfSurvfit) {
  expectGolden(medianOf(goldenTimes("lung")), "median/lung", kClosedForm);
  std::vector<SurvivalTime> flat;
  for (const double seconds : {1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15}) {
    flat.push_back({seconds, seconds < 15});
  }
  expectGolden(medianOf(flat), "median/flat", kClosedForm);
  const std::vector<SurvivalTime> few = {{1, true}, {2, true},  {3, false}, {4, true},
                                         {5, true}, {6, false}, {7, false}, {8, false}};
  expectGolden(medianOf(few), "median/few", kClosedForm);
  EXPECT_TRUE(std::isinf(medianTime(*survivalCurve(few))->upper));
}

TEST(KaplanMeier, WithoutCensoringCountsWhoIsLeft) {
  const SurvivalCurve curve = *survivalCurve({{3, true}, {1, true}, {2, true}, {2, true}});
  ASSERT_EQ(curve.steps.size(), 3u);
  EXPECT_DOUBLE_EQ(curve.steps[0].survival, 0.75);
  EXPECT_DOUBLE_EQ(curve.steps[1].survival, 0.25);
  EXPECT_DOUBLE_EQ(curve.steps[2].survival, 0);
  EXPECT_TRUE(std::isnan(curve.steps[2].standardError));
}

TEST(KaplanMeier, SaysWhyThereIsNoMedian) {
  EXPECT_EQ(survivalCurve({}).reason(), "there are no trials");
  const SurvivalCurve timeOuts = *survivalCurve({{60, false}, {60, false}, {20, true}});
  EXPECT_EQ(medianTime(timeOuts).reason(), "only 1 of 3 trials ended, so the curve never falls to a half");
}

}  // namespace
}  // namespace ocelli::test
