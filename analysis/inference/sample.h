// The mean of a few numbers and how they spread.
#pragma once

#include <vector>

namespace ocelli {

struct SampleMoments {
  double count = 0;
  double mean = 0;
  double variance = 0;  ///< over count - 1; 0 for fewer than 2 numbers, and where they are all alike up to rounding
};

SampleMoments momentsOf(const std::vector<double>& values);

/// second - first; 0 where they are alike up to rounding, as means of the same numbers in other orders are. Without it,
/// rounding would be a spread to test against.
double differenceOf(double first, double second);

/// Of numbers in ascending order, of which there is at least one.
double medianOfSorted(const std::vector<double>& sorted);

/// Ranks from 1, ties (up to rounding) with the mean of theirs.
struct SampleRanks {
  std::vector<double> of;
  double tieSum = 0;  ///< sum of t^3 - t over groups of t ties
};
SampleRanks ranksOf(const std::vector<double>& values);

/// Throws InputError where one is not.
void requireFinite(const std::vector<double>& values, const char* function);

}  // namespace ocelli
