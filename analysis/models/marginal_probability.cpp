#include "analysis/models/marginal_probability.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/models/quadrature.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Enough for 8 digits at standard deviations of 3 logits.
constexpr int kPoints = 40;

struct Average {
  double probability = 0;
  VectorXd gradient;  ///< by the coefficients
};

Average averageOf(const BinomialMixedFit& fit, const Condition& condition) {
  const HermiteRule rule = hermiteRule(kPoints);
  const VectorXd predictor = condition.fixed * fit.coefficients;
  Average average{0, VectorXd::Zero(fit.coefficients.size())};
  for (Index row = 0; row < predictor.size(); ++row) {
    const double spread = std::sqrt(2 * condition.randomVariances[row]);
    double probability = 0;
    double slope = 0;
    for (Index point = 0; point < rule.points.size(); ++point) {
      const double each = 1 / (1 + std::exp(-(predictor[row] + spread * rule.points[point])));
      const double weight = rule.weights[point] * std::numbers::inv_sqrtpi;
      probability += weight * each;
      slope += weight * each * (1 - each);
    }
    average.probability += probability;
    average.gradient += slope * condition.fixed.row(row).transpose();
  }
  const auto rows = static_cast<double>(predictor.size());
  average.probability /= rows;
  average.gradient /= rows;
  return average;
}

}  // namespace

Condition conditionOf(const BinomialMixedModel& model, const BinomialMixedFit& fit, const FixedEffects& fixed,
                      const std::vector<RandomTerm>& random) {
  Condition condition{model.design().rowsLike(fixed), VectorXd::Zero(fixed.rows())};
  bool alike = random.size() == fit.random.size() && fixed.rows() > 0;
  for (size_t i = 0; alike && i < random.size(); ++i) {
    alike = random[i].names == fit.random[i].names && random[i].columns.rows() == fixed.rows();
    if (alike) {
      condition.randomVariances +=
          (random[i].columns * fit.random[i].covariance).cwiseProduct(random[i].columns).rowwise().sum();
    }
  }
  if (!alike) {
    throw InputError("the random effects are not those of the model, or there are no rows", "condition",
                     "the same terms in the same order");
  }
  return condition;
}

Estimate averageProbability(const BinomialMixedFit& fit, const Condition& condition, double level) {
  const Average average = averageOf(fit, condition);
  const double p = average.probability;
  const double slope = p * (1 - p);
  const double standardError = std::sqrt(average.gradient.dot(fit.covariance * average.gradient));
  const Estimate logit =
      estimateOf(std::log(p / (1 - p)), standardError / slope, std::numeric_limits<double>::infinity(), level);
  Estimate estimate;
  estimate.value = p;
  estimate.standardError = standardError;
  estimate.lower = 1 / (1 + std::exp(-logit.lower));
  estimate.upper = 1 / (1 + std::exp(-logit.upper));
  return estimate;
}

Estimate averageProbabilityDifference(const BinomialMixedFit& fit, const Condition& first, const Condition& second,
                                      double level) {
  const Average a = averageOf(fit, first);
  const Average b = averageOf(fit, second);
  const VectorXd gradient = a.gradient - b.gradient;
  return estimateOf(a.probability - b.probability, std::sqrt(gradient.dot(fit.covariance * gradient)),
                    std::numeric_limits<double>::infinity(), level);
}

}  // namespace ocelli
