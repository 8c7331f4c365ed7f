// How numbers are written in a report. One rule for all tables: an estimate, the bounds of its interval and its
// standard error share their decimals, so many that the shorter half of the interval has two significant digits and no
// bound above 0 is written as 0; without an interval, or with more than six decimals, each number has three significant
// digits. P values have three decimals or are "< 0.001", statistics two, degrees of freedom one.
#pragma once

#include <string>

#include "analysis/base/estimate.h"

namespace ocelli {

/// Three significant digits; "not known" where it is not finite.
std::string numberText(double value);
/// "-0.00" is "0.00"; from a million on with an exponent.
std::string fixedText(double value, int decimals);

/// An estimate with what belongs to it: "0.80", "0.67 to 0.95", "0.07". Empty where it is not known.
struct EstimateTexts {
  std::string value;
  std::string interval;
  std::string standardError;
};
EstimateTexts textsOf(const Estimate& estimate);
/// "3.37 (2.39 to 4.35)"; without an interval the value alone.
std::string estimateText(double value, double lower, double upper);

/// "t = -2.10" with finite degrees of freedom, else "z = -2.10"; empty where it is not known.
std::string statisticText(const Estimate& estimate);
/// "23.4"; empty where they are not known or infinite.
std::string degreesText(double degreesOfFreedom);
/// "0.032", "< 0.001"; empty where it is not known.
std::string pValueText(double pValue);
/// "p < 0.001", "p = 0.032", "p not known".
std::string pText(double pValue);

}  // namespace ocelli
