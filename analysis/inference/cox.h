// Proportional hazards: by which factor a covariate multiplies the rate at which trials end, whatever that rate is.
//
//   Cox 1972; Efron 1977                       the partial likelihood, and its form for tied times
//   Lin and Wei 1989                           errors that hold for clusters of trials that are alike
//   Lipsitz, Dear and Zhao 1994                the same for few clusters (cluster_jackknife.h)
//   Grambsch and Therneau 1994                 whether hazards are proportional
//   Therneau 2020, survival 3.x, cox.zph       that test as an exact score test, which is the one here
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

struct CoxTerm {
  std::string name;
  /// z; robust where there are clusters, t for few of them: without an interval and a test where, of few clusters, one
  /// alone tells of the coefficient.
  Estimate logHazardRatio;
  Estimate hazardRatio;           ///< above 1: trials end sooner
  double modelStandardError = 0;  ///< of the logarithm, as if trials were independent
};

struct CoxFit {
  std::vector<CoxTerm> terms;                   ///< as the covariates of the data
  std::vector<std::vector<double>> covariance;  ///< of the coefficients; robust where there are clusters
  double logLikelihood = 0;                     ///< partial
  double nullLogLikelihood = 0;                 ///< with all coefficients 0
  Estimate likelihoodRatio;                     ///< chi-squared, of "all are 0"; takes trials as independent
  Estimate wald;                                ///< chi-squared, of the same; robust where there are clusters, unless
                                                ///< a term has no interval
  size_t trials = 0;
  size_t events = 0;
  size_t clusters = 0;  ///< 0: none were given
  int iterations = 0;
};

/// Not possible without events, where covariates do not vary among those at risk together or depend on each other,
/// where the likelihood grows without bound (no event in one group), with no more clusters than covariates, or where it
/// does not converge. Throws InputError for data that contradict themselves.
Estimable<CoxFit> fitCox(const SurvivalData& data, double level = 0.95);

/// What hazard ratios are checked to be constant against.
enum class TimeScale {
  kSeconds,      ///< "identity"
  kKaplanMeier,  ///< "km": 1 - survival just before; long waits for few events do not weigh so much
};

struct ProportionalityTest {
  std::vector<std::string> names;
  std::vector<Estimate> terms;  ///< chi-squared with 1 degree of freedom, of "this ratio does not change with time"
  Estimate all;                 ///< of all at once
};

/// Of the model that fitCox() fits to these data. It takes trials as independent, also where there are clusters.
Estimable<ProportionalityTest> testProportionality(const SurvivalData& data, TimeScale scale = TimeScale::kKaplanMeier);

}  // namespace ocelli
