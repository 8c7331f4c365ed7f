// Means of a few independent numbers, such as one mean a subject.
//
//   Student 1908   the mean, and the mean of differences of pairs
//   Welch 1947     the difference of two groups whose spreads may differ
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

/// With its test against 0. Not possible for fewer than 2 values or where all are the same.
Estimable<Estimate> studentMean(const std::vector<double>& values, double level = 0.95);

/// Of the means: second - first. Not possible for fewer than 2 values in a group, or where neither has any spread.
Estimable<Estimate> welchDifference(const std::vector<double>& first, const std::vector<double>& second,
                                    double level = 0.95);

}  // namespace ocelli
