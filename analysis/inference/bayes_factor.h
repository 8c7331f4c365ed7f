// How much likelier the data are if there is an effect than if there is none, and the other way round: unlike a p value
// it can speak for "none".
//
//   Rouder, Speckman, Sun, Morey and Iverson 2009, eq. 1   the Jeffreys-Zellner-Siow t test, also of any t statistic
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/binomial_test.h"

namespace ocelli {

struct BayesFactor {
  double logForEffect = 0;  ///< natural logarithm
  double forEffect = 1;  ///< of "there is an effect" against "there is none"; 0 or infinite where it cannot be written
  double forNone = 1;    ///< its inverse
  size_t count = 0;      ///< values or trials
};

/// Half of the standardized effects that are thought possible lie within it.
inline constexpr double kMediumPriorScale = std::numbers::sqrt2 / 2;

/// Of a t statistic of the mean of `count` values, 2 or more.
BayesFactor bayesFactorOfT(double t, size_t count, double priorScale = kMediumPriorScale);

/// Of the mean of differences, one a subject. Not possible for fewer than 2 or where all are the same.
Estimable<BayesFactor> bayesFactorOfMean(const std::vector<double>& differences, double priorScale = kMediumPriorScale);

/// Of an estimate with Student's t, such as clusteredMeanDifference(): as if it were the mean of one independent number
/// more than it has degrees of freedom, which for crossed clusters are the fewer of subjects and cases. It holds for
/// whatever the t does: for other subjects and cases where both are clusters. Not possible without a t, or with less
/// than one degree of freedom.
Estimable<BayesFactor> bayesFactorOfEstimate(const Estimate& estimate, double priorScale = kMediumPriorScale);

/// Of a share that is `chance` if there is no effect, and else anything, as a beta distribution of these parameters
/// says; 1 and 1 for all shares alike. It takes trials as independent. Not possible without trials.
Estimable<BayesFactor> bayesFactorOfShare(const Share& share, double chance, double priorSuccesses = 1,
                                          double priorFailures = 1);

}  // namespace ocelli
