// Intervals by the parametric bootstrap: responses are drawn from the fitted model and fitted again (Davison and
// Hinkley 1997, sections 2.2, 5.3). Percentiles; the same for a seed, whatever the number of threads.
#pragma once

#include <cstdint>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"

namespace ocelli {

struct BootstrapOptions {
  int replicates = 1000;
  uint64_t seed = 1;
  double level = 0.95;
};

/// Of each: value of the fit, standard deviation of the replicates, interval. No statistic, no p-value.
struct BootstrapIntervals {
  std::vector<Estimate> coefficients;
  std::vector<std::vector<Estimate>> standardDeviations;  ///< of the effects of each random term
  int replicates = 0;                                     ///< that could be fitted, and converged
  int failed = 0;
};

/// Impossible where less than nine in ten replicates could be fitted.
Estimable<BootstrapIntervals> parametricBootstrap(const LinearMixedModel& model, const LinearMixedFit& fit,
                                                  const BootstrapOptions& options);
Estimable<BootstrapIntervals> parametricBootstrap(const BinomialMixedModel& model, const BinomialMixedFit& fit,
                                                  const Eigen::VectorXd& trials, const BootstrapOptions& options);

/// How often a likelihood ratio is as large as that of the data where the smaller model is true: (1 + how many) / (1 +
/// replicates). For few subjects, and for variances, for which the chi-squared distribution of likelihoodRatio() is
/// off.
Estimable<Estimate> bootstrapLikelihoodRatio(const BinomialMixedModel& smaller, const BinomialMixedModel& larger,
                                             const BinomialResponse& response, const BootstrapOptions& options);
/// Likewise, by maximum likelihood.
Estimable<Estimate> bootstrapLikelihoodRatio(const LinearMixedModel& smaller, const LinearMixedModel& larger,
                                             const Eigen::VectorXd& response, const BootstrapOptions& options);

}  // namespace ocelli
