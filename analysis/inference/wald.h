// Estimates whose interval is so many standard errors wide on either side, and small things that many methods need.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "analysis/base/estimate.h"

namespace ocelli {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// With the interval of `level`, the statistic (value - null) / standardError and its two-sided p value: of Student's
/// t, or of the normal distribution where the degrees of freedom are infinite. Where the standard error is kNotKnown,
/// so is all but the value; else it is positive.
Estimate waldEstimate(double value, double standardError, double level, double degreesOfFreedom = kInfinite,
                      double null = 0);

/// Of a logarithm, as a ratio: value and interval are exponentiated, the standard error by the delta method; statistic
/// and p value stay those of "the logarithm is 0".
Estimate asRatio(const Estimate& logarithm);

/// A chi-squared statistic with its p value.
Estimate chiSquaredEstimate(double statistic, double degreesOfFreedom);

/// Throws InputError: `what` says what a caller did wrong, `function` which call it was.
void requireArgument(bool holds, const std::string& what, const char* function);

/// Labels such as subjects as indices from 0, in the order of their first appearance.
struct DenseLabels {
  std::vector<size_t> of;  ///< of each row
  size_t count = 0;
};
DenseLabels denseLabels(const std::vector<int>& labels);

}  // namespace ocelli
