#include "analysis/models/mixed_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/base/distributions.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A t interval of one degree of freedom is the widest that two levels give.
constexpr double kMinDegreesOfFreedom = 1;
/// Rounding of a deviance.
constexpr double kSameDeviance = 1e-7;

MatrixXd correlationsOf(const MatrixXd& covariance) {
  MatrixXd correlations = MatrixXd::Identity(covariance.rows(), covariance.cols());
  for (Index i = 0; i < covariance.rows(); ++i) {
    for (Index j = 0; j < i; ++j) {
      const double product = covariance(i, i) * covariance(j, j);
      correlations(i, j) = correlations(j, i) = product > 0 ? covariance(i, j) / std::sqrt(product) : 0;
    }
  }
  return correlations;
}

void describeBoundary(RandomTermFit& term, const MatrixXd& lower, MixedModelFit& fit) {
  for (Index effect = 0; effect < lower.rows(); ++effect) {
    if (lower(effect, effect) >= kSingularDeviation) {
      continue;
    }
    term.atBoundary = true;
    const std::string& name = term.names[static_cast<size_t>(effect)];
    if (term.relativeDeviations[effect] < kSingularDeviation) {
      fit.boundary.push_back(fmt::format("the variance of {} by {} is 0", name, term.group));
    } else {
      fit.boundary.push_back(
          fmt::format("other effects of {} determine {}: a correlation is 1 or -1", term.group, name));
    }
  }
}

}  // namespace

Estimable<Index> coefficientIndex(const MixedModelFit& fit, const std::string& name) {
  const auto found = std::find(fit.names.begin(), fit.names.end(), name);
  if (found != fit.names.end()) {
    return static_cast<Index>(found - fit.names.begin());
  }
  for (const DroppedColumn& column : fit.dropped) {
    if (column.name == name) {
      return Estimable<Index>::impossible(fmt::format("{} was dropped: {}", name, column.reason));
    }
  }
  return Estimable<Index>::impossible(fmt::format("the model has no coefficient {}", name));
}

Estimable<Estimate> likelihoodRatio(const MixedModelFit& smaller, const MixedModelFit& larger) {
  using Result = Estimable<Estimate>;
  if (smaller.rows != larger.rows) {
    return Result::impossible("the two models are of different rows");
  }
  if (smaller.restricted != larger.restricted || (smaller.restricted && smaller.names != larger.names)) {
    return Result::impossible("restricted likelihoods compare models of the same fixed effects only");
  }
  if (smaller.parameters >= larger.parameters) {
    return Result::impossible("the larger model has no parameter more than the smaller one");
  }
  if (!smaller.convergence.converged || !larger.convergence.converged) {
    return Result::impossible("one of the two models did not converge");
  }
  const double statistic = smaller.deviance - larger.deviance;
  if (statistic < -1e-4) {
    return Result::impossible("the larger model fits worse, and so the smaller one is no part of it");
  }
  Estimate estimate;
  estimate.value = estimate.statistic = std::max(0.0, statistic);
  estimate.degreesOfFreedom = larger.parameters - smaller.parameters;
  estimate.pValue = chiSquaredTail(estimate.statistic, estimate.degreesOfFreedom);
  return estimate;
}

Estimate contrastEstimate(const MixedModelFit& fit, const VectorXd& contrast, double level) {
  const double variance = contrast.dot(fit.covariance * contrast);
  double degreesOfFreedom = std::numeric_limits<double>::infinity();
  if (!fit.covarianceGradients.empty()) {
    VectorXd gradient(static_cast<Index>(fit.covarianceGradients.size()));
    for (Index i = 0; i < gradient.size(); ++i) {
      gradient[i] = contrast.dot(fit.covarianceGradients[static_cast<size_t>(i)] * contrast);
    }
    degreesOfFreedom = 2 * variance * variance / gradient.dot(fit.varianceParameterCovariance * gradient);
    degreesOfFreedom = std::max(degreesOfFreedom, kMinDegreesOfFreedom);
  }
  return estimateOf(contrast.dot(fit.coefficients), std::sqrt(variance), degreesOfFreedom, level);
}

Estimable<Estimate> coefficientEstimate(const MixedModelFit& fit, const std::string& name, double level) {
  const Estimable<Index> index = coefficientIndex(fit, name);
  if (!index) {
    return Estimable<Estimate>::impossible(index.reason());
  }
  return contrastEstimate(fit, VectorXd::Unit(fit.coefficients.size(), *index), level);
}

Estimate estimateOf(double value, double standardError, double degreesOfFreedom, double level) {
  Estimate estimate;
  estimate.value = value;
  estimate.standardError = standardError;
  if (!(standardError > 0) || !std::isfinite(standardError)) {
    return estimate;
  }
  estimate.statistic = value / standardError;
  estimate.degreesOfFreedom = degreesOfFreedom;
  if (!(degreesOfFreedom > 0)) {
    return estimate;
  }
  const double reach = studentQuantile((1 + level) / 2, degreesOfFreedom) * standardError;
  estimate.lower = value - reach;
  estimate.upper = value + reach;
  estimate.pValue = 2 * studentTail(std::abs(estimate.statistic), degreesOfFreedom);
  return estimate;
}

void describeFit(const Design& design, const RandomStructure& structure, const Minimum& minimum,
                 const VectorXd& scaledTheta, const VectorXd& b, double variance, MixedModelFit& fit) {
  fit.rows = design.rows();
  fit.names = design.fixedNames;
  fit.dropped = design.dropped;
  fit.theta = structure.thetaOf(scaledTheta);
  for (size_t i = 0; i < design.random.size(); ++i) {
    RandomTermFit term;
    term.group = design.random[i].group;
    term.levels = design.random[i].levels;
    term.names = design.random[i].names;
    term.covariance = variance * structure.covarianceOf(i, scaledTheta);
    term.standardDeviations = term.covariance.diagonal().cwiseSqrt();
    term.correlations = correlationsOf(term.covariance);
    term.effects = structure.effectsOf(i, b);
    const MatrixXd lower = structure.templateOf(i, scaledTheta);
    term.relativeDeviations = lower.rowwise().norm();
    describeBoundary(term, lower, fit);
    fit.random.push_back(std::move(term));
  }
  fit.singular = !fit.boundary.empty();
  fit.convergence = {minimum.converged, minimum.reason, minimum.evaluations, minimum.expectedDecrease};
  for (const DroppedColumn& column : design.dropped) {
    fit.warnings.push_back(fmt::format("{} was dropped: {}", column.name, column.reason));
  }
  if (!fit.convergence.converged) {
    fit.warnings.push_back(fmt::format("the fit did not converge: {}", fit.convergence.reason));
  }
  for (const std::string& clause : fit.boundary) {
    fit.warnings.push_back(fmt::format("the fit is singular: {}", clause));
  }
}

void settleAtBoundary(const RandomStructure& structure, const Objective& deviance, Minimum& minimum) {
  VectorXd signs = VectorXd::Ones(minimum.point.size());
  signs.head(structure.thetaSize()) = structure.signsOf(minimum.point);
  minimum.point = signs.cwiseProduct(minimum.point);
  minimum.gradient = signs.cwiseProduct(minimum.gradient);
  minimum.hessian = (signs.asDiagonal() * minimum.hessian * signs.asDiagonal()).eval();
  for (const Index diagonal : structure.diagonals()) {
    if (minimum.point[diagonal] == 0 || minimum.point[diagonal] > 10 * kSingularDeviation) {
      continue;
    }
    VectorXd settled = minimum.point;
    settled[diagonal] = 0;
    const double value = deviance(settled);
    if (value <= minimum.value + kSameDeviance) {
      minimum.point = settled;
      minimum.value = value;
    }
  }
}

}  // namespace ocelli
