// Whether a difference is too small to matter, which a large p value of a usual test does not show: two one-sided
// tests, against the bounds of what would matter.
//
//   Schuirmann 1987; Lakens 2017   TOST: equivalent where the interval of 1 - 2 alpha lies within the bounds
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/binomial_test.h"
#include "analysis/inference/mcnemar.h"

namespace ocelli {

/// In units of the difference, the lower one below the upper one. They are chosen before the data are seen.
struct EquivalenceBounds {
  double lower = 0;
  double upper = 0;
};

struct EquivalenceTest {
  EquivalenceBounds bounds;
  double alpha = 0.05;
  Estimate difference;     ///< second - first, with the interval of 1 - 2 alpha; its p value is of "it is 0"
  double pAboveLower = 1;  ///< one-sided, of "it is at most the lower bound"
  double pBelowUpper = 1;
  double pValue = 1;  ///< the larger of the two
  bool equivalent = false;
  size_t first = 0;   ///< values or trials
  size_t second = 0;  ///< as many as first where they are pairs
};

/// Of any difference with a standard error, such as a coefficient of a model. The error is positive.
EquivalenceTest equivalenceOf(double difference, double standardError, double degreesOfFreedom,
                              const EquivalenceBounds& bounds, double alpha = 0.05);

/// Of the mean of differences, one a subject. Not possible for fewer than 2 or where all are the same. Throws
/// InputError for bounds that enclose nothing, as all of these do.
Estimable<EquivalenceTest> equivalenceOfPairedMeans(const std::vector<double>& differences,
                                                    const EquivalenceBounds& bounds, double alpha = 0.05);

/// Of the means of two groups, with Welch's degrees of freedom.
Estimable<EquivalenceTest> equivalenceOfMeans(const std::vector<double>& first, const std::vector<double>& second,
                                              const EquivalenceBounds& bounds, double alpha = 0.05);

/// Of shares of independent trials; Wald's standard error. Not possible where both are 0 or 1.
Estimable<EquivalenceTest> equivalenceOfShares(const Share& first, const Share& second, const EquivalenceBounds& bounds,
                                               double alpha = 0.05);

/// Of shares of paired trials; Wald's standard error. Not possible where no pair differs.
Estimable<EquivalenceTest> equivalenceOfPairedShares(const PairedCounts& counts, const EquivalenceBounds& bounds,
                                                     double alpha = 0.05);

}  // namespace ocelli
