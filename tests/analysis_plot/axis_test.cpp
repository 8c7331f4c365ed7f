#include "analysis/plot/axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ocelli {
namespace {

double perLetter(const std::string& label) {
  return 5.0 * static_cast<double>(label.size());
}

std::vector<std::string> labelsOf(const Axis& axis) {
  std::vector<std::string> labels;
  for (const AxisTick& tick : axis.ticks()) {
    if (!tick.label.empty()) {
      labels.push_back(tick.label);
    }
  }
  return labels;
}

AxisRange rangeOf(double low, double high, AxisScale scale = AxisScale::kLinear) {
  return AxisRange::of({low, high}, scale);
}

TEST(Axis, marksRoundNumbersAndEndsThere) {
  const Axis axis(rangeOf(3, 58), 0, 300, perLetter);
  EXPECT_EQ(axis.low(), 0);
  EXPECT_EQ(axis.high(), 60);
  EXPECT_THAT(labelsOf(axis), testing::ElementsAre("0", "10", "20", "30", "40", "50", "60"));
}

TEST(Axis, mapsValuesEvenlyAndHoldsThoseBeyond) {
  const Axis axis(rangeOf(0, 60), 100, 400, perLetter);
  EXPECT_DOUBLE_EQ(axis.at(0), 100);
  EXPECT_DOUBLE_EQ(axis.at(15), 175);
  EXPECT_DOUBLE_EQ(axis.at(600), 400);
  const Axis upward(rangeOf(0, 10), 200, 0, [](const std::string&) { return 10.0; });
  EXPECT_DOUBLE_EQ(upward.at(2.5), 150);
}

TEST(Axis, labelsNeverTouchHoweverShortItIs) {
  for (const AxisScale scale : {AxisScale::kLinear, AxisScale::kLog}) {
    for (const double high : {1.5, 40.0, 12345.0, 3e9}) {
      for (const double length : {60.0, 90.0, 200.0, 500.0}) {
        const Axis axis(rangeOf(1, high, scale), 0, length, perLetter);
        double end = -1e9;
        for (const AxisTick& tick : axis.ticks()) {
          if (!tick.label.empty()) {
            EXPECT_GT(axis.at(tick.value) - perLetter(tick.label) / 2, end) << high << " in " << length;
            end = axis.at(tick.value) + perLetter(tick.label) / 2;
          }
        }
      }
    }
  }
}

TEST(Axis, logarithmsAreEqualStepsForEqualRatios) {
  const Axis axis(rangeOf(2, 50, AxisScale::kLog), 0, 300, perLetter);
  EXPECT_NEAR(axis.at(8) - axis.at(4), axis.at(40) - axis.at(20), 1e-9);
  EXPECT_THAT(labelsOf(axis), testing::ElementsAre("2", "5", "10", "20", "50"));
  EXPECT_THAT(labelsOf(Axis(rangeOf(0.3, 2, AxisScale::kLog), 0, 300, perLetter)),
              testing::ElementsAre("0.2", "0.5", "1", "2"));
}

TEST(Axis, whatIsNoNumberDoesNotCount) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const AxisRange range = AxisRange::of({nan, 2, std::numeric_limits<double>::infinity(), 4});
  EXPECT_EQ(range.low, 2);
  EXPECT_EQ(range.high, 4);
  const AxisRange log = AxisRange::of({0, -3, 5, 50}, AxisScale::kLog);
  EXPECT_EQ(log.low, 5);
  EXPECT_EQ(AxisRange::of({nan}).high, 1);
}

TEST(Axis, equalValuesStillHaveAnAxis) {
  for (const double value : {0.0, 7.0, -3.0, 1e-9, 1e9}) {
    const Axis axis(rangeOf(value, value), 0, 200, perLetter);
    EXPECT_LT(axis.low(), value);
    EXPECT_GT(axis.high(), value);
    EXPECT_GE(axis.ticks().size(), 2U);
  }
}

TEST(Axis, wholeNumbersHaveNoTicksBetween) {
  AxisRange range = rangeOf(1, 3);
  range.whole = true;
  const Axis axis(range, 0, 900, perLetter);
  for (const AxisTick& tick : axis.ticks()) {
    EXPECT_EQ(tick.value, std::round(tick.value));
  }
}

TEST(Axis, numbersAreWrittenAsInPrint) {
  EXPECT_EQ(numberText(-1234567.5, 1), "\u22121,234,567.5");
  EXPECT_EQ(numberText(-0.0001, 2), "0.00");
  EXPECT_EQ(numberText(std::nan(""), 2), "\u2013");
  EXPECT_EQ(shortNumberText(0.01234), "0.0123");
  EXPECT_EQ(shortNumberText(1234.5), "1,234");
  EXPECT_EQ(percentText(0.436, 1), "43.6\u00a0%");
}

}  // namespace
}  // namespace ocelli
