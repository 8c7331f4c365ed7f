#include "analysis/models/linear_mixed_model.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Random effects as free as fixed ones, all but this one part in a hundred thousand.
constexpr double kFreeTheta = 1e5;

}  // namespace

/// The deviance of one response as a function of theta. The response is less its least-squares fit, and of unit
/// variance.
class LinearMixedModel::Profile {
 public:
  Profile(const LinearMixedModel& model, const VectorXd& response, bool restricted)
      : model_(model), cholesky_(model.structure_), restricted_(restricted) {
    const MatrixXd& basis = model.design_.basis;
    leastSquares_ = basis.transpose() * response;
    VectorXd rest = response - basis * leastSquares_;
    const VectorXd more = basis.transpose() * rest;
    rest -= basis * more;
    leastSquares_ += more;
    scale_ = rest.norm() / std::sqrt(rest.size());
    const double size = response.norm() / std::sqrt(response.size());
    if (scale_ <= kNoResiduals * size) {
      scale_ = 0;
      return;
    }
    rest /= scale_;
    squares_ = rest.squaredNorm();
    right_.resize(model.structure_.size(), basis.cols() + 1);
    right_ << model.randomFixed_, model.structure_.transposedTimes(rest);
  }

  /// Standard deviation about the least-squares fit; 0 where that is exact.
  double scale() const { return scale_; }
  const VectorXd& leastSquares() const { return leastSquares_; }  ///< coordinates in the basis
  Index freedom() const { return model_.design_.rows() - (restricted_ ? fixedCount() : 0); }

  /// Equations 34 and 41, with the response and the fixed effects in their own units.
  double at(const VectorXd& theta) {
    solve(theta);
    const auto freedom = static_cast<double>(this->freedom());
    double deviance =
        cholesky_.logDeterminant() +
        freedom * (1 + std::log(2 * std::numbers::pi * penalizedSquares_ / freedom) + 2 * std::log(scale_));
    if (restricted_) {
      deviance += 2 * fixedFactor_.diagonal().array().log().sum();
      deviance += 2 * model_.design_.triangle.diagonal().array().abs().log().sum();
    }
    return deviance;
  }

  // At the theta of the last call of at(), in units of scale().
  double penalizedSquares() const { return penalizedSquares_; }
  double residualVariance() const { return penalizedSquares_ / static_cast<double>(freedom()); }
  /// Covariance of the coordinates of the fixed effects over the residual variance.
  MatrixXd relativeCovariance() const {
    const MatrixXd inverse =
        fixedFactor_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(fixedCount(), fixedCount()));
    return inverse.transpose() * inverse;
  }
  VectorXd coordinates() const { return fixedFactor_.transpose().triangularView<Eigen::Upper>().solve(fixedSolution_); }
  VectorXd sphericalEffects() const {
    return cholesky_.backward(reduced_.col(fixedCount()) - reduced_.leftCols(fixedCount()) * coordinates());
  }

 private:
  Index fixedCount() const { return model_.design_.basis.cols(); }

  /// Section 3.2: the Cholesky factor of the whole system, block by block.
  void solve(const VectorXd& theta) {
    cholesky_.factorize(theta, model_.crossProduct_);
    MatrixXd right = right_;
    model_.structure_.multiplyByLambdaTransposed(theta, right);
    reduced_ = cholesky_.forward(right);
    const auto randomFixed = reduced_.leftCols(fixedCount());
    const auto randomResponse = reduced_.col(fixedCount());
    const MatrixXd fixedSquares =
        MatrixXd::Identity(fixedCount(), fixedCount()) - randomFixed.transpose() * randomFixed;
    fixedFactor_ = fixedSquares.llt().matrixL();
    fixedSolution_ = fixedFactor_.triangularView<Eigen::Lower>().solve(-(randomFixed.transpose() * randomResponse));
    penalizedSquares_ = squares_ - randomResponse.squaredNorm() - fixedSolution_.squaredNorm();
  }

  const LinearMixedModel& model_;
  PenalizedCholesky cholesky_;
  bool restricted_;
  VectorXd leastSquares_{};
  double scale_ = 0;
  double squares_ = 0;
  MatrixXd right_{};  ///< Z'Q, Z'y

  MatrixXd reduced_{};      ///< L^-1 P Lambda' right_
  MatrixXd fixedFactor_{};  ///< lower triangle: the transpose of R_X
  VectorXd fixedSolution_{};
  double penalizedSquares_ = 0;
};

LinearMixedModel::LinearMixedModel(Design design)
    : design_(std::move(design)),
      structure_(design_.random, design_.rows()),
      crossProduct_(structure_.crossProduct(VectorXd::Ones(design_.rows()))),
      randomFixed_(structure_.transposedTimes(design_.basis)) {}

double LinearMixedModel::deviance(const VectorXd& response, const VectorXd& theta, bool restricted) const {
  return Profile(*this, response, restricted).at(structure_.scaledThetaOf(theta));
}

Estimable<LinearMixedFit> LinearMixedModel::fit(const VectorXd& response, bool restricted) const {
  using Result = Estimable<LinearMixedFit>;
  if (response.size() != design_.rows() || !response.allFinite()) {
    throw InputError("the response has a value that is not finite, or not one a row", "linear mixed model",
                     "rows without missing values");
  }
  if (const std::optional<std::string> reason = whyImpossible(design_, true)) {
    return Result::impossible(*reason);
  }
  if ((response.array() == response[0]).all()) {
    return Result::impossible("all responses are equal");
  }
  Profile profile(*this, response, restricted);
  if (profile.scale() == 0) {
    return Result::impossible("the fixed effects reproduce the responses exactly");
  }
  profile.at(kFreeTheta * structure_.startTheta());
  if (!(profile.residualVariance() > kNoResiduals)) {
    return Result::impossible("fixed and random effects reproduce the responses exactly");
  }
  const Objective deviance = [&](const VectorXd& theta) { return profile.at(theta); };
  const MinimumSearch search;
  Minimum minimum = findMinimum(deviance, structure_.startTheta(), search);
  settleAtBoundary(structure_, deviance, minimum);
  const VectorXd& theta = minimum.point;

  LinearMixedFit fit;
  fit.deviance = deviance(theta);
  fit.restricted = restricted;
  fit.parameters = static_cast<int>(design_.fixed.cols() + structure_.thetaSize()) + 1;
  const double variance = profile.residualVariance();
  const VectorXd b = profile.scale() * structure_.lambdaTimes(theta, profile.sphericalEffects());
  const VectorXd coordinates = profile.leastSquares() + profile.scale() * profile.coordinates();
  fit.residualDeviation = profile.scale() * std::sqrt(variance);
  describeFit(design_, structure_, minimum, theta, b, fit.residualDeviation * fit.residualDeviation, fit);
  const auto triangle = design_.triangle.triangularView<Eigen::Upper>();
  fit.coefficients = triangle.solve(coordinates);
  fit.fitted = design_.basis * coordinates + structure_.times(b);
  fit.residuals = response - fit.fitted;

  const auto inUnits = [&](const MatrixXd& relative) -> MatrixXd {
    const MatrixXd half = triangle.solve(relative * (profile.scale() * profile.scale()));
    return triangle.solve(half.transpose());
  };
  const MatrixXd relative = profile.relativeCovariance();
  fit.covariance = inUnits(variance * relative);
  fit.standardErrors = fit.covariance.diagonal().cwiseSqrt();

  // The deviance of theta and sigma, not profiled: -2 log likelihood = log |L|^2 + r^2(theta) / sigma^2 + freedom log
  // sigma^2
  // + ..., whose Hessian follows from that of the profiled one and the gradient of r^2.
  const Index size = theta.size();
  const double sigma = std::sqrt(variance);
  const auto freedom = static_cast<double>(profile.freedom());
  VectorXd squaresGradient(size);
  for (Index i = 0; i < size; ++i) {
    VectorXd shifted = theta;
    shifted[i] += search.hessianStep;
    profile.at(shifted);
    double squares = profile.penalizedSquares();
    MatrixXd covariance = profile.relativeCovariance();
    shifted[i] -= 2 * search.hessianStep;
    profile.at(shifted);
    squares -= profile.penalizedSquares();
    covariance -= profile.relativeCovariance();
    squaresGradient[i] = squares / (2 * search.hessianStep);
    fit.covarianceGradients.push_back(inUnits(variance * covariance / (2 * search.hessianStep)));
  }
  fit.covarianceGradients.push_back(inUnits(2 * sigma * relative));
  MatrixXd hessian(size + 1, size + 1);
  hessian.topLeftCorner(size, size) =
      minimum.hessian + squaresGradient * squaresGradient.transpose() / (freedom * variance * variance);
  hessian.col(size).head(size) = -2 * squaresGradient / (sigma * variance);
  hessian.row(size).head(size) = hessian.col(size).head(size).transpose();
  hessian(size, size) = 4 * freedom / variance;
  fit.varianceParameterCovariance = covarianceOfMinimum(hessian);
  return fit;
}

VectorXd LinearMixedModel::simulate(const LinearMixedFit& fit, RandomNumbers& numbers) const {
  const VectorXd u = VectorXd::NullaryExpr(structure_.size(), [&] { return fit.residualDeviation * numbers.normal(); });
  const VectorXd b = structure_.lambdaTimes(structure_.scaledThetaOf(fit.theta), u);
  VectorXd response = design_.fixed * fit.coefficients + structure_.times(b);
  for (double& value : response) {
    value += fit.residualDeviation * numbers.normal();
  }
  return response;
}

}  // namespace ocelli
