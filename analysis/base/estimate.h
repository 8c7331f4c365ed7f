// One number with what is known about it.
#pragma once

#include <limits>

namespace ocelli {

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// What a method does not give is kNotKnown.
struct Estimate {
  double value = kNotKnown;
  double standardError = kNotKnown;
  double lower = kNotKnown;  ///< of the interval with the level that was asked for, 95 % unless told
  double upper = kNotKnown;
  double statistic = kNotKnown;         ///< t, z, chi-squared or F, as the method says
  double degreesOfFreedom = kNotKnown;  ///< infinite for z
  double pValue = kNotKnown;            ///< two-sided, of "it is 0" unless the method says otherwise
};

}  // namespace ocelli
