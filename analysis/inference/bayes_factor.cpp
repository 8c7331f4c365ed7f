#include "analysis/inference/bayes_factor.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

BayesFactor factorOf(double logForEffect, size_t count) {
  return {logForEffect, std::exp(logForEffect), std::exp(-logForEffect), count};
}

}  // namespace

BayesFactor bayesFactorOfT(double t, size_t count, double priorScale) {
  requireArgument(count >= 2 && std::isfinite(t) && priorScale > 0, "t, count or scale is invalid", "bayesFactorOfT");
  const auto n = static_cast<double>(count);
  const double df = n - 1;
  // Over u = log g, where the integrand has a single peak.
  const auto logIntegrand = [&](double u) {
    const double spread = 1 + n * std::exp(u) * priorScale * priorScale;
    return -std::log(spread) / 2 - (df + 1) / 2 * std::log1p(t * t / (spread * df)) -
           std::log(2 * std::numbers::pi) / 2 - u / 2 - std::exp(-u) / 2;
  };
  double peak = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (double u = -20; u <= 80; u += 0.25) {
    const double value = logIntegrand(u);
    if (value > most) {
      most = value;
      peak = u;
    }
  }
  // Scaled by the peak, which may be too small or large for a number. It falls as exp(-u) above and much faster below.
  const auto integrand = [&](double u) { return std::exp(logIntegrand(u) - most); };
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double integral = Quadrature::integrate(integrand, peak - 30, peak, 12, 1e-13) +
                          Quadrature::integrate(integrand, peak, peak + 80, 12, 1e-13);
  return factorOf(most + std::log(integral) + (df + 1) / 2 * std::log1p(t * t / df), count);
}

Estimable<BayesFactor> bayesFactorOfMean(const std::vector<double>& differences, double priorScale) {
  requireFinite(differences, "bayesFactorOfMean");
  if (differences.size() < 2) {
    return Estimable<BayesFactor>::impossible(
        fmt::format("there are {} differences, and 2 are needed", differences.size()));
  }
  const SampleMoments moments = momentsOf(differences);
  if (moments.variance == 0) {
    return Estimable<BayesFactor>::impossible("all differences are the same");
  }
  return bayesFactorOfT(moments.mean / std::sqrt(moments.variance / moments.count), differences.size(), priorScale);
}

Estimable<BayesFactor> bayesFactorOfEstimate(const Estimate& estimate, double priorScale) {
  if (!std::isfinite(estimate.statistic) || !std::isfinite(estimate.degreesOfFreedom) ||
      estimate.degreesOfFreedom < 1) {
    return Estimable<BayesFactor>::impossible("there is no t statistic with a degree of freedom or more");
  }
  const auto count = static_cast<size_t>(std::llround(estimate.degreesOfFreedom)) + 1;
  return bayesFactorOfT(estimate.statistic, count, priorScale);
}

Estimable<BayesFactor> bayesFactorOfShare(const Share& share, double chance, double priorSuccesses,
                                          double priorFailures) {
  requireArgument(share.successes >= 0 && share.successes <= share.trials, "more successes than trials",
                  "bayesFactorOfShare");
  requireArgument(chance > 0 && chance < 1, "the chance is not between 0 and 1", "bayesFactorOfShare");
  requireArgument(priorSuccesses > 0 && priorFailures > 0, "the prior is invalid", "bayesFactorOfShare");
  if (share.trials == 0) {
    return Estimable<BayesFactor>::impossible("there are no trials");
  }
  const int failures = share.trials - share.successes;
  const double effect =
      logBeta(priorSuccesses + share.successes, priorFailures + failures) - logBeta(priorSuccesses, priorFailures);
  const double none = share.successes * std::log(chance) + failures * std::log1p(-chance);
  return factorOf(effect - none, static_cast<size_t>(share.trials));
}

}  // namespace ocelli
