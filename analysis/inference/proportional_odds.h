// By which factor a covariate multiplies the odds of a higher answer, the same between all steps of the scale.
//
//   McCullagh 1980   logit P(answer <= k) = threshold_k - x beta
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/covariate.h"

namespace ocelli {

struct OddsTerm {
  std::string name;
  Estimate logOddsRatio;  ///< z
  Estimate oddsRatio;     ///< above 1: higher answers
};

struct ProportionalOddsFit {
  std::vector<OddsTerm> terms;       ///< as the covariates
  std::vector<int> answers;          ///< those that were given at all, ascending
  std::vector<Estimate> thresholds;  ///< between one of these and the next; the p value means nothing
  double logLikelihood = 0;
  Estimate likelihoodRatio;  ///< chi-squared, of "all coefficients are 0"
  size_t count = 0;
  int iterations = 0;
};

/// It takes answers as independent: one a subject. Not possible where all answers are the same, where covariates do not
/// vary or depend on each other, where the likelihood grows without bound (all low answers in one group), or where it
/// does not converge. Throws InputError for lists of different lengths.
Estimable<ProportionalOddsFit> fitProportionalOdds(const std::vector<int>& answers,
                                                   const std::vector<Covariate>& covariates, double level = 0.95);

}  // namespace ocelli
