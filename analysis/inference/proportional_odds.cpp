#include "analysis/inference/proportional_odds.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/inference/standardized_covariates.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kOddsIterations = 100;
/// Of the decrease that a Newton step still promises, in units of the log-likelihood.
constexpr double kOddsConverged = 1e-18;

struct OddsLikelihood {
  double logLikelihood = 0;
  VectorXd score;
  MatrixXd information;
};

/// The logistic distribution up to a threshold, which for the last answer is infinite and for the one before the first
/// minus that.
struct Edge {
  double probability = 0;
  double density = 0;
  double slope = 0;
  VectorXd direction;  ///< derivative of threshold - x beta

  Edge(double position, VectorXd derivative)
      : probability(1 / (1 + std::exp(-position))),
        density(probability * (1 - probability)),
        slope(density * (1 - 2 * probability)),
        direction(std::move(derivative)) {}
};

/// At `theta`: thresholds, then coefficients. `steps`: index of the answer of each row among those that were given.
OddsLikelihood likelihoodAt(const std::vector<Index>& steps, const MatrixXd& x, Index thresholds,
                            const VectorXd& theta) {
  const Index size = theta.size();
  OddsLikelihood value{0, VectorXd::Zero(size), MatrixXd::Zero(size, size)};
  const VectorXd eta = x * theta.tail(x.cols());
  const auto edge = [&](Index k, Index row) {
    VectorXd direction = VectorXd::Zero(size);
    if (k < 0 || k == thresholds) {
      return Edge(k < 0 ? -kInfinite : kInfinite, direction);
    }
    direction[k] = 1;
    direction.tail(x.cols()) = -x.row(row).transpose();
    return Edge(theta[k] - eta[row], std::move(direction));
  };
  for (size_t i = 0; i < steps.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const Edge above = edge(steps[i], row);
    const Edge below = edge(steps[i] - 1, row);
    const double probability = above.probability - below.probability;
    if (!(probability > 0)) {
      value.logLikelihood = -kInfinite;
      return value;
    }
    value.logLikelihood += std::log(probability);
    const VectorXd score = (above.density * above.direction - below.density * below.direction) / probability;
    value.score += score;
    value.information += score * score.transpose() - (above.slope * above.direction * above.direction.transpose() -
                                                      below.slope * below.direction * below.direction.transpose()) /
                                                         probability;
  }
  return value;
}

/// Thresholds that give each answer its share, and no effects.
VectorXd startOf(const std::vector<Index>& steps, Index thresholds, Index covariates) {
  VectorXd theta = VectorXd::Zero(thresholds + covariates);
  for (Index k = 0; k < thresholds; ++k) {
    const auto upTo =
        static_cast<double>(std::count_if(steps.begin(), steps.end(), [&](Index step) { return step <= k; }));
    theta[k] = std::log(upTo / (static_cast<double>(steps.size()) - upTo));
  }
  return theta;
}

}  // namespace

Estimable<ProportionalOddsFit> fitProportionalOdds(const std::vector<int>& answers,
                                                   const std::vector<Covariate>& covariates, double level) {
  using Result = Estimable<ProportionalOddsFit>;
  const StandardizedCovariates standardized(covariates, answers.size(), "fitProportionalOdds");
  if (!standardized.problem.empty()) {
    return Result::impossible(standardized.problem);
  }
  const std::set<int> given(answers.begin(), answers.end());
  if (given.size() < 2) {
    return Result::impossible("all answers are the same");
  }
  std::vector<Index> steps;
  for (const int answer : answers) {
    steps.push_back(static_cast<Index>(std::distance(given.begin(), given.find(answer))));
  }
  const MatrixXd& x = standardized.values;
  if (const std::string reason = standardized.whyNotIndependent(x.transpose() * x); !reason.empty()) {
    return Result::impossible(reason);
  }
  const auto thresholds = static_cast<Index>(given.size()) - 1;
  VectorXd theta = startOf(steps, thresholds, x.cols());
  OddsLikelihood value = likelihoodAt(steps, x, thresholds, theta);
  const OddsLikelihood null = value;
  ProportionalOddsFit fit;
  for (fit.iterations = 1;; ++fit.iterations) {
    if (fit.iterations > kOddsIterations) {
      return Result::impossible(fmt::format("the fit did not converge in {} steps", kOddsIterations));
    }
    if (const auto flat = flatDirection(value.information, null.information)) {
      const auto most = static_cast<Index>(*flat) - thresholds;
      return Result::impossible(
          fmt::format("the likelihood grows without bound in '{}', as where one group has all the higher answers",
                      standardized.names[static_cast<size_t>(std::max(most, Index{0}))]));
    }
    const VectorXd step = value.information.ldlt().solve(value.score);
    if (!(step.dot(value.score) > kOddsConverged * (1 + std::abs(value.logLikelihood)))) {
      break;
    }
    double length = 1;
    OddsLikelihood next = likelihoodAt(steps, x, thresholds, theta + step);
    // Near the maximum the likelihood cannot tell steps apart any more.
    const double slack = 1e-13 * std::abs(value.logLikelihood);
    while (!(next.logLikelihood >= value.logLikelihood - slack) && length > 1e-9) {
      length /= 2;
      next = likelihoodAt(steps, x, thresholds, theta + length * step);
    }
    theta += length * step;
    value = next;
  }
  // Back from standardized covariates: raw = back * standardized.
  MatrixXd back = MatrixXd::Identity(theta.size(), theta.size());
  for (Index j = 0; j < x.cols(); ++j) {
    back(thresholds + j, thresholds + j) = 1 / standardized.scale[j];
    back.col(thresholds + j).head(thresholds).setConstant(standardized.mean[j] / standardized.scale[j]);
  }
  theta = back * theta;
  const MatrixXd covariance = back * value.information.inverse() * back.transpose();
  const auto estimate = [&](Index j) { return waldEstimate(theta[j], std::sqrt(covariance(j, j)), level); };
  for (Index k = 0; k < thresholds; ++k) {
    fit.thresholds.push_back(estimate(k));
  }
  for (Index j = 0; j < x.cols(); ++j) {
    const Estimate logarithm = estimate(thresholds + j);
    fit.terms.push_back({standardized.names[static_cast<size_t>(j)], logarithm, asRatio(logarithm)});
  }
  fit.answers.assign(given.begin(), given.end());
  fit.logLikelihood = value.logLikelihood;
  fit.likelihoodRatio =
      chiSquaredEstimate(2 * (value.logLikelihood - null.logLikelihood), static_cast<double>(x.cols()));
  fit.count = answers.size();
  return fit;
}

}  // namespace ocelli
