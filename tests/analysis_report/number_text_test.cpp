// The rule of digits of all tables.
#include "analysis/report/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ocelli {
namespace {

Estimate of(double value, double standardError, double lower, double upper) {
  Estimate estimate;
  estimate.value = value;
  estimate.standardError = standardError;
  estimate.lower = lower;
  estimate.upper = upper;
  return estimate;
}

TEST(NumberText, anEstimateSharesItsDecimalsWithBoundsAndError) {
  const EstimateTexts ratio = textsOf(of(0.8, 0.0712, 0.6661, 0.95));
  EXPECT_EQ(ratio.value, "0.80");
  EXPECT_EQ(ratio.interval, "0.67 to 0.95");
  EXPECT_EQ(ratio.standardError, "0.07");
  const EstimateTexts seconds = textsOf(of(-21.04, 4.4, -30.1, -11.96));
  EXPECT_EQ(seconds.value, "-21.0");
  EXPECT_EQ(seconds.interval, "-30.1 to -12.0");
  EXPECT_EQ(seconds.standardError, "4.4");
}

TEST(NumberText, noBoundIsZeroThatIsNone) {
  EXPECT_EQ(textsOf(of(22, 1, 0.00295, 165623)).interval, "0.003 to 165623.000");
}

TEST(NumberText, hasExponentsWhereDecimalsWouldHideIt) {
  EXPECT_EQ(textsOf(of(3e-16, 1e-16, 1e-16, 5e-16)).value, "3.00e-16");
  EXPECT_EQ(textsOf(of(2, 1, 1, 4.2e12)).interval, "1.0 to 4.20e+12");
}

TEST(NumberText, withoutAnIntervalThereAreThreeDigits) {
  EXPECT_EQ(textsOf(of(1, kNotKnown, kNotKnown, kNotKnown)).value, "1.00");
  EXPECT_EQ(textsOf(of(1, kNotKnown, 1, 1)).interval, "");
  EXPECT_EQ(textsOf(of(kNotKnown, kNotKnown, 0, 1)).value, "");
}

TEST(NumberText, statisticsSayTheirKind) {
  Estimate estimate;
  estimate.statistic = -2.1;
  estimate.degreesOfFreedom = 23.44;
  EXPECT_EQ(statisticText(estimate), "t = -2.10");
  EXPECT_EQ(degreesText(estimate.degreesOfFreedom), "23.4");
  estimate.degreesOfFreedom = std::numeric_limits<double>::infinity();
  EXPECT_EQ(statisticText(estimate), "z = -2.10");
  EXPECT_EQ(degreesText(estimate.degreesOfFreedom), "");
  EXPECT_EQ(statisticText({}), "");
}

TEST(NumberText, pValuesHaveThreeDecimals) {
  EXPECT_EQ(pValueText(0.0321), "0.032");
  EXPECT_EQ(pValueText(0.00099), "< 0.001");
  EXPECT_EQ(pValueText(1), "1.000");
  EXPECT_EQ(pValueText(kNotKnown), "");
}

}  // namespace
}  // namespace ocelli
