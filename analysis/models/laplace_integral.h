// The likelihood of a mixed model whose responses are not normal: the integral over the random effects by Laplace's
// approximation, whose mode comes from penalized iteratively reweighted least squares (Bates, Maechler, Bolker, Walker
// 2015, J. Stat. Softw. 67(1), and lme4's theory vignette), or for one random effect a level by adaptive Gauss-Hermite
// quadrature (Pinheiro and Bates 1995). Where responses are normal, Laplace's approximation is exact.
//
// linear predictor = offset + columns * coordinates + Z Lambda(theta) scale u,  u of variance I
#pragma once

#include "analysis/models/mixed_model.h"
#include "analysis/models/quadrature.h"
#include "analysis/models/response_family.h"

namespace ocelli {

/// `variances` are theta and then the parameters of the family. Structure and family must stay.
class LaplaceIntegral {
 public:
  /// `columns`: of the fixed effects, which have coordinates as their coefficients. `points` of quadrature: 1 is
  /// Laplace's approximation.
  LaplaceIntegral(const RandomStructure& structure, ResponseFamily& family, Eigen::MatrixXd columns, int points = 1);

  /// From the best coordinates at `variances` on, coordinates are the distance from these, with about unit variance.
  void whiten(const Eigen::VectorXd& variances);
  const Eigen::VectorXd& origin() const { return origin_; }
  const Eigen::MatrixXd& units() const { return units_; }

  // -2 log likelihood.
  double at(const Eigen::VectorXd& variances, const Eigen::VectorXd& coordinates);
  /// With the coordinates at the mode of the penalized likelihood, which is where the search starts.
  double atBestCoordinates(const Eigen::VectorXd& variances);
  /// With the integral over the coordinates too.
  double restrictedAt(const Eigen::VectorXd& variances);

  /// Of the coordinates, at the penalized mode.
  Eigen::MatrixXd covarianceAt(const Eigen::VectorXd& variances);

  // After the last call.
  const Eigen::VectorXd& coordinates() const { return coordinates_; }  ///< of atBestCoordinates()
  Eigen::VectorXd randomEffects() const;                               ///< Lambda scale u at the mode
  const Eigen::VectorXd& linearPredictor() const { return predictor_; }

 private:
  void set(const Eigen::VectorXd& variances);
  void findMode(Eigen::VectorXd* fixed);
  double penalizedDeviance(const Eigen::VectorXd& u, const Eigen::VectorXd& fixedPart);
  void newtonStep(bool withFixed, Eigen::VectorXd& step, Eigen::VectorXd& fixedStep);
  double laplace() const;
  double quadrature();

  const RandomStructure& structure_;
  ResponseFamily& family_;
  PenalizedCholesky cholesky_;
  HermiteRule rule_;
  Eigen::VectorXd offset_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd coordinates_;
  Eigen::VectorXd origin_;  ///< where whitened coordinates are 0
  Eigen::MatrixXd units_;   ///< of whitened coordinates

  Eigen::VectorXd theta_{};  ///< times the family's scale
  Eigen::VectorXd u_;
  Eigen::VectorXd fixedPart_{};
  Eigen::VectorXd predictor_{};
  Eigen::MatrixXd fixedFactor_{};  ///< lower triangle: inverse covariance of the coordinates, its factor
};

}  // namespace ocelli
