// Tests and shifts by ranks, for numbers whose distribution is not normal or that only have an order.
//
//   Wilcoxon 1945; Mann and Whitney 1947   the tests
//   Hodges and Lehmann 1963                the estimates: medians of the means, or differences, of all pairs
//   Hollander, Wolfe and Chicken 2014      the intervals, from the same lists (sections 3.3, 4.3)
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

struct SignedRankTest {
  double positiveRanks = 0;  ///< the statistic: sum of ranks of the values above 0
  size_t count = 0;
  size_t zeros = 0;    ///< of these, without rank
  bool exact = false;  ///< fewer than 50 values, without ties and zeros; else normal with a correction for continuity
  /// Of the center, from all values. Bounds are kNotKnown where there are too few values for the level.
  Estimate center;
};

/// Pairs of values that a test holds in memory. More are refused by an InputError: take one value a subject, not one
/// a trial.
inline constexpr size_t kMaxPairs = 20000000;

/// Against a center of 0. Not possible where all values are 0.
Estimable<SignedRankTest> signedRankTest(const std::vector<double>& values, double level = 0.95);

struct RankSumTest {
  double statistic = 0;  ///< pairs in which the second is larger, ties as a half
  size_t first = 0;
  size_t second = 0;
  bool exact = false;  ///< fewer than 50 values in each group, without ties
  Estimate shift;      ///< of the second group from the first; bounds as above
};

/// Not possible where a group is empty or all values are the same.
Estimable<RankSumTest> rankSumTest(const std::vector<double>& first, const std::vector<double>& second,
                                   double level = 0.95);

}  // namespace ocelli
