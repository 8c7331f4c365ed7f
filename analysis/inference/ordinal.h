// Answers on a scale such as 1 to 5, whose steps are ordered but not equally wide.
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/binomial_test.h"
#include "analysis/inference/wilcoxon.h"

namespace ocelli {

struct OrdinalDistribution {
  std::vector<int> counts;       ///< of 1, 2, ...
  std::vector<Estimate> shares;  ///< with Wilson's intervals
  int answers = 0;
  int belowMiddle = 0;
  int atMiddle = 0;  ///< 0 where the number of steps is even: the middle lies between two answers
  int aboveMiddle = 0;
  double mean = 0;  ///< as if the steps were equally wide
  double median = 0;
};

/// `answers` from 1 to `steps`, two or more; the middle is (steps + 1) / 2. Not possible without answers. Throws
/// InputError for other numbers, as does the test.
Estimable<OrdinalDistribution> ordinalDistribution(const std::vector<int>& answers, int steps = 5, double level = 0.95);

struct MiddleTest {
  BinomialTest sign;          ///< answers above the middle among those not at it, against a half
  SignedRankTest signedRank;  ///< of answer - middle; the center is how far from the middle
};

/// Whether answers lean to one side. Not possible where all are at the middle.
Estimable<MiddleTest> testAgainstMiddle(const std::vector<int>& answers, int steps = 5, double level = 0.95);

}  // namespace ocelli
