#include "analysis/models/binomial_mixed_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "analysis/base/analysis_error.h"
#include "analysis/models/quadrature.h"
#include "analysis/models/separation.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostQuadraturePoints = 25;
constexpr int kMostIterations = 100;
/// Squared length of a step after which the mode is exact enough for differences of the deviance.
constexpr double kModeReached = 1e-18;
/// A relative standard deviation, of logits: odds of e^30 between levels are those of levels that have no common odds.
constexpr double kLargestTheta = 30;

double logBinomialCoefficients(const BinomialResponse& response) {
  double sum = 0;
  for (Index row = 0; row < response.trials.size(); ++row) {
    const double n = response.trials[row];
    const double k = response.successes[row];
    if (k > 0 && k < n) {
      sum += std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    }
  }
  return sum;
}

/// From a start that is near, with steps that the exactness of the mode allows.
MinimumSearch nearbySearch() {
  MinimumSearch search;
  search.firstStep = 0.1;
  search.lastStep = 5e-3;
  search.gradientStep = 5e-4;
  search.hessianStep = 1e-2;
  search.hessianReach = 1e-3;
  return search;
}

/// Separation does not depend on the units of the columns.
std::optional<std::string> whySeparated(const Design& design, const BinomialResponse& response) {
  const VectorXd lengths = design.fixed.colwise().lpNorm<Eigen::Infinity>();
  const MatrixXd columns = design.fixed * lengths.cwiseInverse().asDiagonal();
  std::vector<std::string> names;
  for (const Index column : separatedColumns(columns, response.successes, response.trials)) {
    names.push_back(design.fixedNames[static_cast<size_t>(column)]);
  }
  if (names.empty()) {
    return std::nullopt;
  }
  return fmt::format(
      "the answers are separated: they are all of one kind in some combination of conditions, where {} {}",
      fmt::join(names, ", "), names.size() == 1 ? "has no finite estimate" : "have no finite estimates");
}

}  // namespace

/// The deviance of one response. Fixed effects are coordinates: linear predictor = offset + columns * coordinates + Z
/// b.
class BinomialMixedModel::Integral {
 public:
  /// `columns`: of the fixed effects, which have coordinates as their coefficients.
  Integral(const RandomStructure& structure, const BinomialResponse& response, int points, MatrixXd columns)
      : structure_(structure),
        response_(response),
        cholesky_(structure),
        constant_(-2 * logBinomialCoefficients(response)),
        rule_(hermiteRule(points)),
        offset_(VectorXd::Zero(columns.rows())),
        columns_(std::move(columns)),
        coordinates_(VectorXd::Zero(columns_.cols())),
        origin_(coordinates_),
        units_(MatrixXd::Identity(columns_.cols(), columns_.cols())),
        u_(VectorXd::Zero(structure.size())) {}

  /// From the best coordinates at theta on, coordinates are the distance from these, with about unit variance.
  void whiten(const VectorXd& theta) {
    atBestCoordinates(theta);
    const Index count = columns_.cols();
    origin_ = coordinates_;
    units_ = fixedFactor_.transpose().triangularView<Eigen::Upper>().solve(MatrixXd::Identity(count, count));
    offset_ = columns_ * origin_;
    columns_ = columns_ * units_;
    coordinates_ = VectorXd::Zero(count);
  }
  const VectorXd& origin() const { return origin_; }
  const MatrixXd& units() const { return units_; }

  double at(const VectorXd& theta, const VectorXd& coordinates) {
    fixedPart_ = offset_ + columns_ * coordinates;
    findMode(theta, nullptr);
    return rule_.points.size() == 1 ? laplace() : quadrature(theta);
  }

  /// With the coordinates at the mode of the penalized likelihood, which is where the search starts.
  double atBestCoordinates(const VectorXd& theta) {
    fixedPart_ = offset_ + columns_ * coordinates_;
    findMode(theta, &coordinates_);
    return laplace();
  }

  /// With the integral over the coordinates too.
  double restrictedAt(const VectorXd& theta) {
    const double deviance = atBestCoordinates(theta);
    return deviance + 2 * fixedFactor_.diagonal().array().log().sum() -
           static_cast<double>(columns_.cols()) * std::log(2 * std::numbers::pi);
  }

  /// Of the coordinates, at the penalized mode.
  MatrixXd covarianceAt(const VectorXd& theta) {
    atBestCoordinates(theta);
    const Index count = columns_.cols();
    const MatrixXd inverse = fixedFactor_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(count, count));
    return inverse.transpose() * inverse;
  }

  // After the last call.
  const VectorXd& coordinates() const { return coordinates_; }  ///< of atBestCoordinates()
  const MatrixXd& fixedFactor() const {
    return fixedFactor_;
  }  ///< lower triangle: inverse covariance of them, its factor
  const VectorXd& mode() const { return u_; }
  const VectorXd& linearPredictor() const { return predictor_; }
  const VectorXd& probabilities() const { return probabilities_; }

 private:
  /// Newton's method for the mode of u, and of the fixed coordinates where these are given: step-halved, from the last
  /// one.
  void findMode(const VectorXd& theta, VectorXd* fixed) {
    double penalized = penalizedDeviance(theta, u_, fixedPart_);
    if (!std::isfinite(penalized)) {
      u_.setZero();
      penalized = penalizedDeviance(theta, u_, fixedPart_);
    }
    VectorXd step;
    VectorXd fixedStep;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      newtonStep(theta, fixed, step, fixedStep);
      const double length = step.squaredNorm() + (fixed ? fixedStep.squaredNorm() : 0);
      if (length < kModeReached) {
        return;
      }
      double share = 1;
      VectorXd next = u_ + step;
      VectorXd nextFixedPart = fixed ? fixedPart_ + columns_ * fixedStep : fixedPart_;
      double value = penalizedDeviance(theta, next, nextFixedPart);
      for (int halving = 0; halving < 30 && !(value <= penalized + 1e-9); ++halving) {
        share /= 2;
        next = u_ + share * step;
        if (fixed) {
          nextFixedPart = fixedPart_ + columns_ * (share * fixedStep);
        }
        value = penalizedDeviance(theta, next, nextFixedPart);
      }
      u_ = next;
      penalized = value;
      if (fixed) {
        *fixed += share * fixedStep;
        fixedPart_ = nextFixedPart;
      }
    }
  }

  /// Sets predictor_, probabilities_ and deviance_ (of the trials given u), and adds the penalty.
  double penalizedDeviance(const VectorXd& theta, const VectorXd& u, const VectorXd& fixedPart) {
    predictor_ = fixedPart + structure_.times(structure_.lambdaTimes(theta, u));
    const Eigen::ArrayXd shrunk = (-predictor_.array().abs()).exp();
    const Eigen::ArrayXd softplus = predictor_.array().max(0.0) + (1 + shrunk).log();
    const Eigen::ArrayXd larger = (1 + shrunk).inverse();
    probabilities_ = (predictor_.array() >= 0).select(larger, 1 - larger);
    deviance_ = -2 * (response_.successes.array() * predictor_.array() - response_.trials.array() * softplus).sum();
    return deviance_ + u.squaredNorm();
  }

  void newtonStep(const VectorXd& theta, const VectorXd* fixed, VectorXd& step, VectorXd& fixedStep) {
    const VectorXd weights = response_.trials.array() * probabilities_.array() * (1 - probabilities_.array());
    const VectorXd rest = response_.successes - response_.trials.cwiseProduct(probabilities_);
    cholesky_.factorize(theta, structure_.crossProduct(weights));
    const Index count = fixed ? columns_.cols() : 0;
    MatrixXd right(structure_.rows(), count + 1);
    if (fixed) {
      right.leftCols(count) = weights.asDiagonal() * columns_;
    }
    right.col(count) = rest;
    MatrixXd reduced = structure_.transposedTimes(right);
    structure_.multiplyByLambdaTransposed(theta, reduced);
    reduced.col(count) -= u_;
    reduced = cholesky_.forward(reduced);
    if (fixed) {
      const auto randomFixed = reduced.leftCols(count);
      const MatrixXd squares = columns_.transpose() * right.leftCols(count) - randomFixed.transpose() * randomFixed;
      const Eigen::LLT<MatrixXd> factor(squares);
      fixedFactor_ = factor.matrixL();
      fixedStep = factor.solve(columns_.transpose() * rest - randomFixed.transpose() * reduced.col(count));
      reduced.col(count) -= randomFixed * fixedStep;
    }
    step = cholesky_.backward(reduced.col(count));
  }

  double laplace() const { return constant_ + deviance_ + u_.squaredNorm() + cholesky_.logDeterminant(); }

  /// One effect a level: each level has an integral of its own, about its mode and scaled by the curvature there.
  double quadrature(const VectorXd& theta) {
    const RandomStructure::Term& term = structure_.terms()[0];
    const Eigen::ArrayXd spread = std::numbers::sqrt2 * cholesky_.scalarDiagonal().array().rsqrt();
    const VectorXd mode = u_;
    MatrixXd logs(structure_.size(), rule_.points.size());
    for (Index point = 0; point < rule_.points.size(); ++point) {
      const double x = rule_.points[point];
      const VectorXd u = mode.array() + spread * x;
      const VectorXd predictor = fixedPart_ + structure_.times(structure_.lambdaTimes(theta, u));
      VectorXd sums = x * x + std::log(rule_.weights[point]) - u.array().square() / 2;
      for (Index row = 0; row < predictor.size(); ++row) {
        const double eta = predictor[row];
        const double softplus = std::max(eta, 0.0) + std::log1p(std::exp(-std::abs(eta)));
        sums[term.levelOfRow[static_cast<size_t>(row)]] +=
            response_.successes[row] * eta - response_.trials[row] * softplus;
      }
      logs.col(point) = sums;
    }
    double sum = 0;
    for (Index level = 0; level < logs.rows(); ++level) {
      const double largest = logs.row(level).maxCoeff();
      sum += largest + std::log((logs.row(level).array() - largest).exp().sum()) + std::log(spread[level]) -
             std::log(2 * std::numbers::pi) / 2;
    }
    return constant_ - 2 * sum;
  }

  const RandomStructure& structure_;
  const BinomialResponse& response_;
  PenalizedCholesky cholesky_;
  double constant_;
  HermiteRule rule_;
  VectorXd offset_;
  MatrixXd columns_;
  VectorXd coordinates_;
  VectorXd origin_;  ///< where whitened coordinates are 0
  MatrixXd units_;   ///< of whitened coordinates

  VectorXd u_;
  VectorXd fixedPart_{};
  VectorXd predictor_{};
  VectorXd probabilities_{};
  double deviance_ = 0;
  MatrixXd fixedFactor_{};
};

BinomialResponse binaryResponse(const std::vector<bool>& successes) {
  const auto size = static_cast<Index>(successes.size());
  BinomialResponse response{VectorXd::Zero(size), VectorXd::Ones(size)};
  for (Index row = 0; row < size; ++row) {
    response.successes[row] = successes[static_cast<size_t>(row)] ? 1 : 0;
  }
  return response;
}

BinomialMixedModel::BinomialMixedModel(Design design)
    : design_(std::move(design)), structure_(design_.random, design_.rows()) {}

void BinomialMixedModel::check(const BinomialResponse& response, int quadraturePoints) const {
  const auto fail = [](const std::string& what, const std::string& next) {
    throw AnalysisError(AnalysisError::Kind::kInput, what, "binomial mixed model", next);
  };
  const Index rows = design_.rows();
  if (response.successes.size() != rows || response.trials.size() != rows) {
    fail(fmt::format("the response has not {} rows", rows), "successes and trials of each row");
  }
  for (Index row = 0; row < rows; ++row) {
    const double k = response.successes[row];
    const double n = response.trials[row];
    if (!(n >= 1 && k >= 0 && k <= n && std::floor(n) == n && std::floor(k) == k && std::isfinite(n))) {
      fail(fmt::format("{} successes of {} trials in row {}", k, n, row + 1),
           "whole numbers, 0 to the number of trials");
    }
  }
  const bool scalar = design_.random.size() == 1 && design_.random[0].names.size() == 1;
  if (quadraturePoints < 1 || quadraturePoints > kMostQuadraturePoints || (quadraturePoints > 1 && !scalar)) {
    fail(fmt::format("{} points of quadrature", quadraturePoints),
         "1 point, or up to 25 for a model with one random effect of one grouping factor");
  }
}

double BinomialMixedModel::deviance(const BinomialResponse& response, const VectorXd& theta,
                                    const VectorXd& coefficients, int quadraturePoints) const {
  check(response, quadraturePoints);
  Integral integral(structure_, response, quadraturePoints, design_.fixed);
  return integral.at(structure_.scaledThetaOf(theta), coefficients);
}

std::optional<std::string> BinomialMixedModel::whyNot(const BinomialResponse& response) const {
  const bool binary = (response.trials.array() == 1).all();
  if (std::optional<std::string> reason = whyImpossible(design_, binary)) {
    return reason;
  }
  if (response.successes.isZero(0) || response.successes == response.trials) {
    return "all responses are equal";
  }
  return whySeparated(design_, response);
}

/// Columns of the basis are scaled by this, so that coordinates are of the order of logits.
double BinomialMixedModel::columnLength() const {
  return std::sqrt(static_cast<double>(design_.rows()));
}

Estimable<BinomialMixedFit> BinomialMixedModel::describe(Integral& integral, const Minimum& minimum,
                                                         const MatrixXd& covariance) const {
  const VectorXd theta = minimum.point.head(structure_.thetaSize());
  if (theta.lpNorm<Eigen::Infinity>() > kLargestTheta) {
    return Estimable<BinomialMixedFit>::impossible(
        "the levels of a grouping factor differ without limit: each has responses of one kind");
  }
  const VectorXd coordinates = minimum.point.tail(design_.fixed.cols());
  BinomialMixedFit fit;
  fit.deviance = integral.at(theta, coordinates);
  fit.parameters = static_cast<int>(minimum.point.size());
  describeFit(design_, structure_, minimum, theta, structure_.lambdaTimes(theta, integral.mode()), 1, fit);
  const auto triangle = design_.triangle.triangularView<Eigen::Upper>();
  fit.coefficients = triangle.solve(columnLength() * (integral.origin() + integral.units() * coordinates));
  const MatrixXd units = triangle.solve(columnLength() * integral.units());
  fit.covariance = units * covariance * units.transpose();
  fit.standardErrors = fit.covariance.diagonal().cwiseSqrt();
  fit.linearPredictor = integral.linearPredictor();
  fit.fitted = integral.probabilities();
  return fit;
}

Estimable<BinomialMixedFit> BinomialMixedModel::fit(const BinomialResponse& response, int quadraturePoints) const {
  check(response, quadraturePoints);
  if (const std::optional<std::string> reason = whyNot(response)) {
    return Estimable<BinomialMixedFit>::impossible(*reason);
  }
  // First theta alone, with the fixed effects at the penalized mode; then both.
  Integral integral(structure_, response, quadraturePoints, columnLength() * design_.basis);
  MinimumSearch first;
  first.lastStep = 0.02;
  const VectorXd start = nearMinimum([&](const VectorXd& theta) { return integral.atBestCoordinates(theta); },
                                     structure_.startTheta(), first);
  integral.whiten(start);
  const Index thetaCount = structure_.thetaSize();
  const Index fixedCount = design_.fixed.cols();
  const Objective deviance = [&](const VectorXd& point) {
    return integral.at(point.head(thetaCount), point.tail(fixedCount));
  };
  VectorXd together = VectorXd::Zero(thetaCount + fixedCount);
  together.head(thetaCount) = start;
  Minimum minimum = findMinimum(deviance, together, nearbySearch());
  settleAtBoundary(structure_, deviance, minimum);
  Estimable<BinomialMixedFit> fit =
      describe(integral, minimum, covarianceOfMinimum(minimum.hessian).bottomRightCorner(fixedCount, fixedCount));
  if (!fit) {
    return fit;
  }
  BinomialMixedFit result = *fit;
  result.quadraturePoints = quadraturePoints;
  return result;
}

Estimable<BinomialMixedFit> BinomialMixedModel::fitRestricted(const BinomialResponse& response) const {
  check(response, 1);
  if (const std::optional<std::string> reason = whyNot(response)) {
    return Estimable<BinomialMixedFit>::impossible(*reason);
  }
  Integral integral(structure_, response, 1, columnLength() * design_.basis);
  const Objective restricted = [&](const VectorXd& theta) { return integral.restrictedAt(theta); };
  MinimumSearch search = nearbySearch();
  search.firstStep = 0.5;
  Minimum variances = findMinimum(restricted, structure_.startTheta(), search);
  settleAtBoundary(structure_, restricted, variances);
  const VectorXd theta = variances.point;

  integral.whiten(theta);
  const Index fixedCount = design_.fixed.cols();
  const Objective deviance = [&](const VectorXd& coordinates) { return integral.at(theta, coordinates); };
  const Minimum fixed = findMinimum(deviance, VectorXd::Zero(fixedCount), nearbySearch());
  Minimum both = fixed.converged ? variances : fixed;
  both.evaluations = variances.evaluations + fixed.evaluations;
  both.point.resize(theta.size() + fixedCount);
  both.point << theta, fixed.point;
  const Estimable<BinomialMixedFit> fit = describe(integral, both, covarianceOfMinimum(fixed.hessian));
  if (!fit) {
    return fit;
  }

  BinomialMixedFit result = *fit;
  result.restricted = true;
  const auto triangle = design_.triangle.triangularView<Eigen::Upper>();
  const MatrixXd units = triangle.solve(columnLength() * integral.units());
  // In the units of the coefficients.
  result.deviance = integral.restrictedAt(theta) - 2 * units.diagonal().array().abs().log().sum();
  result.varianceParameterCovariance = covarianceOfMinimum(variances.hessian);
  for (Index i = 0; i < theta.size(); ++i) {
    VectorXd shifted = theta;
    shifted[i] += search.hessianStep;
    MatrixXd difference = integral.covarianceAt(shifted);
    shifted[i] -= 2 * search.hessianStep;
    difference -= integral.covarianceAt(shifted);
    result.covarianceGradients.push_back(units * (difference / (2 * search.hessianStep)) * units.transpose());
  }
  return result;
}

BinomialResponse BinomialMixedModel::simulate(const BinomialMixedFit& fit, const VectorXd& trials,
                                              RandomNumbers& numbers) const {
  const VectorXd u = VectorXd::NullaryExpr(structure_.size(), [&] { return numbers.normal(); });
  const VectorXd b = structure_.lambdaTimes(structure_.scaledThetaOf(fit.theta), u);
  const VectorXd predictor = design_.fixed * fit.coefficients + structure_.times(b);
  BinomialResponse response{VectorXd::Zero(trials.size()), trials};
  for (Index row = 0; row < trials.size(); ++row) {
    const double probability = 1 / (1 + std::exp(-predictor[row]));
    for (int trial = 0; trial < static_cast<int>(trials[row]); ++trial) {
      response.successes[row] += numbers.uniform() < probability ? 1 : 0;
    }
  }
  return response;
}

}  // namespace ocelli
