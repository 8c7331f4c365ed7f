#include "analysis/models/laplace_integral.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 100;
/// Squared length of a step after which the mode is exact enough for differences of the deviance.
constexpr double kModeReached = 1e-18;

}  // namespace

LaplaceIntegral::LaplaceIntegral(const RandomStructure& structure, ResponseFamily& family, MatrixXd columns, int points)
    : structure_(structure),
      family_(family),
      cholesky_(structure),
      rule_(hermiteRule(points)),
      offset_(VectorXd::Zero(columns.rows())),
      columns_(std::move(columns)),
      coordinates_(VectorXd::Zero(columns_.cols())),
      origin_(coordinates_),
      units_(MatrixXd::Identity(columns_.cols(), columns_.cols())),
      u_(VectorXd::Zero(structure.size())) {}

void LaplaceIntegral::whiten(const VectorXd& variances) {
  atBestCoordinates(variances);
  const Index count = columns_.cols();
  origin_ = coordinates_;
  units_ = fixedFactor_.transpose().triangularView<Eigen::Upper>().solve(MatrixXd::Identity(count, count));
  offset_ = columns_ * origin_;
  columns_ = columns_ * units_;
  coordinates_ = VectorXd::Zero(count);
}

double LaplaceIntegral::at(const VectorXd& variances, const VectorXd& coordinates) {
  set(variances);
  fixedPart_ = offset_ + columns_ * coordinates;
  findMode(nullptr);
  return rule_.points.size() == 1 ? laplace() : quadrature();
}

double LaplaceIntegral::atBestCoordinates(const VectorXd& variances) {
  set(variances);
  fixedPart_ = offset_ + columns_ * coordinates_;
  findMode(&coordinates_);
  return laplace();
}

double LaplaceIntegral::restrictedAt(const VectorXd& variances) {
  const double deviance = atBestCoordinates(variances);
  return deviance + 2 * fixedFactor_.diagonal().array().log().sum() -
         static_cast<double>(columns_.cols()) * std::log(2 * std::numbers::pi);
}

MatrixXd LaplaceIntegral::covarianceAt(const VectorXd& variances) {
  atBestCoordinates(variances);
  const Index count = columns_.cols();
  const MatrixXd inverse = fixedFactor_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(count, count));
  return inverse.transpose() * inverse;
}

VectorXd LaplaceIntegral::randomEffects() const {
  return structure_.lambdaTimes(theta_, u_);
}

void LaplaceIntegral::set(const VectorXd& variances) {
  family_.setParameters(variances.tail(family_.parameterCount()));
  theta_ = family_.scale() * variances.head(structure_.thetaSize());
}

/// Newton's method for the mode of u, and of the fixed coordinates where these are given: step-halved, from the last
/// one.
void LaplaceIntegral::findMode(VectorXd* fixed) {
  double penalized = penalizedDeviance(u_, fixedPart_);
  if (!std::isfinite(penalized)) {
    u_.setZero();
    penalized = penalizedDeviance(u_, fixedPart_);
  }
  VectorXd step;
  VectorXd fixedStep;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    newtonStep(fixed != nullptr, step, fixedStep);
    const double length = step.squaredNorm() + (fixed ? fixedStep.squaredNorm() : 0);
    if (length < kModeReached) {
      return;
    }
    double share = 1;
    VectorXd next = u_ + step;
    VectorXd nextFixedPart = fixed ? fixedPart_ + columns_ * fixedStep : fixedPart_;
    double value = penalizedDeviance(next, nextFixedPart);
    for (int halving = 0; halving < 30 && !(value <= penalized + 1e-9); ++halving) {
      share /= 2;
      next = u_ + share * step;
      if (fixed) {
        nextFixedPart = fixedPart_ + columns_ * (share * fixedStep);
      }
      value = penalizedDeviance(next, nextFixedPart);
    }
    u_ = next;
    penalized = value;
    if (fixed) {
      *fixed += share * fixedStep;
      fixedPart_ = nextFixedPart;
    }
  }
}

/// Of the rows given u, and the penalty.
double LaplaceIntegral::penalizedDeviance(const VectorXd& u, const VectorXd& fixedPart) {
  predictor_ = fixedPart + structure_.times(structure_.lambdaTimes(theta_, u));
  family_.evaluate(predictor_);
  return family_.deviance() + u.squaredNorm();
}

void LaplaceIntegral::newtonStep(bool withFixed, VectorXd& step, VectorXd& fixedStep) {
  const VectorXd& weights = family_.curvatures();
  const VectorXd& slopes = family_.slopes();
  cholesky_.factorize(theta_, structure_.crossProduct(weights));
  const Index count = withFixed ? columns_.cols() : 0;
  MatrixXd right(structure_.rows(), count + 1);
  if (withFixed) {
    right.leftCols(count) = weights.asDiagonal() * columns_;
  }
  right.col(count) = slopes;
  MatrixXd reduced = structure_.transposedTimes(right);
  structure_.multiplyByLambdaTransposed(theta_, reduced);
  reduced.col(count) -= u_;
  reduced = cholesky_.forward(reduced);
  if (withFixed) {
    const auto randomFixed = reduced.leftCols(count);
    const MatrixXd squares = columns_.transpose() * right.leftCols(count) - randomFixed.transpose() * randomFixed;
    const Eigen::LLT<MatrixXd> factor(squares);
    fixedFactor_ = factor.matrixL();
    fixedStep = factor.solve(columns_.transpose() * slopes - randomFixed.transpose() * reduced.col(count));
    reduced.col(count) -= randomFixed * fixedStep;
  }
  step = cholesky_.backward(reduced.col(count));
}

double LaplaceIntegral::laplace() const {
  return family_.constant() + family_.deviance() + u_.squaredNorm() + cholesky_.logDeterminant();
}

/// One effect a level: each level has an integral of its own, about its mode and scaled by the curvature there.
double LaplaceIntegral::quadrature() {
  const RandomStructure::Term& term = structure_.terms()[0];
  const Eigen::ArrayXd spread = std::numbers::sqrt2 * cholesky_.scalarDiagonal().array().rsqrt();
  MatrixXd logs(structure_.size(), rule_.points.size());
  for (Index point = 0; point < rule_.points.size(); ++point) {
    const double x = rule_.points[point];
    const VectorXd u = u_.array() + spread * x;
    const VectorXd predictor = fixedPart_ + structure_.times(structure_.lambdaTimes(theta_, u));
    VectorXd sums = x * x + std::log(rule_.weights[point]) - u.array().square() / 2;
    for (Index row = 0; row < predictor.size(); ++row) {
      sums[term.levelOfRow[static_cast<size_t>(row)]] += family_.logDensity(row, predictor[row]);
    }
    logs.col(point) = sums;
  }
  double sum = 0;
  for (Index level = 0; level < logs.rows(); ++level) {
    const double largest = logs.row(level).maxCoeff();
    sum += largest + std::log((logs.row(level).array() - largest).exp().sum()) + std::log(spread[level]) -
           std::log(2 * std::numbers::pi) / 2;
  }
  return family_.constant() - 2 * sum;
}

}  // namespace ocelli
