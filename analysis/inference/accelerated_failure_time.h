// Log-normal accelerated failure time: by which factor a covariate makes the times longer, where some are censored.
//
//   Kalbfleisch and Prentice 2002, chapter 3   the model: log T = intercept + x beta + sigma Z
//   Lin and Wei 1989                           errors that hold for clusters of trials that are alike
//   Lipsitz, Dear and Zhao 1994                the same for few clusters (cluster_jackknife.h)
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

struct TimeRatioTerm {
  std::string name;
  /// z; robust where there are clusters, t for few of them: without an interval and a test where, of few clusters, one
  /// alone tells of the coefficient.
  Estimate logTimeRatio;
  Estimate timeRatio;             ///< above 1: trials take longer
  double modelStandardError = 0;  ///< of the logarithm, as if trials were independent
};

struct FailureTimeFit {
  Estimate intercept;                ///< log seconds, where all covariates are 0
  std::vector<TimeRatioTerm> terms;  ///< as the covariates of the data
  Estimate logSigma;                 ///< of the standard deviation of log seconds; the p value means nothing
  std::vector<std::vector<double>>
      covariance;  ///< of intercept, coefficients, log sigma; robust where there are clusters
  double logLikelihood = 0;
  size_t trials = 0;
  size_t events = 0;
  size_t clusters = 0;  ///< 0: none were given
  int iterations = 0;
};

/// Without covariates it fits the intercept and sigma alone. Not possible without events, with a time of 0, with
/// covariates that do not vary or depend on each other, where the likelihood grows without bound (no event in one
/// group, a perfect fit), with no more clusters than coefficients, or where it does not converge. Throws InputError
/// for data that contradict themselves, and for strata, which this model has none of.
Estimable<FailureTimeFit> fitLogNormal(const SurvivalData& data, double level = 0.95);

}  // namespace ocelli
