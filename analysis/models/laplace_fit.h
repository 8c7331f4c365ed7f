// The fit of a mixed model by Laplace's approximation, whatever its responses are: variances, then coefficients, and
// what MixedModelFit says of them.
#pragma once

#include "analysis/models/laplace_integral.h"

namespace ocelli {

/// The design's basis, of which coordinates are of the order of the predictor.
Eigen::MatrixXd laplaceColumns(const Design& design);

/// Steps that suit the exactness of the mode, from a start that is near.
MinimumSearch laplaceSearch();

/// Variances by the restricted likelihood, Laplace's approximation of the integral over the fixed effects too (as REML
/// in Brooks et al. 2017, glmmTMB, The R Journal 9(2), appendix A), and coordinates by Laplace's approximation at these
/// variances. Standard errors do not treat variances of few levels as known, which Wald's z does. DEVIATION: the
/// covariance of the coordinates as a function of the variances is that at the mode of the penalized likelihood, up to
/// the factor by which its curvature differs from that of Laplace's approximation.
struct RestrictedOptimum {
  Minimum minimum;             ///< its point: variances, then whitened coordinates
  Eigen::VectorXd variances;   ///< theta, then the parameters of the family
  double deviance = 0;         ///< of the restricted likelihood, in coordinates
  Eigen::MatrixXd covariance;  ///< of the whitened coordinates
  Eigen::MatrixXd varianceCovariance;
  std::vector<Eigen::MatrixXd> covarianceGradients;  ///< of `covariance`, by each variance
};
/// `integral` is whitened afterwards. `start` and `search`: of the variances.
RestrictedOptimum restrictedOptimum(LaplaceIntegral& integral, const RandomStructure& structure,
                                    const Eigen::VectorXd& start, const MinimumSearch& search);

/// What was done to the response before it was fitted: less `leastSquares` (coordinates in the design's basis), over
/// `scale`.
struct ResponseUnits {
  Eigen::VectorXd leastSquares{};  ///< empty: nothing was taken off
  double scale = 1;
};

/// Fills all of `fit` but what is said of the rows. `minimum`: at variances and whitened coordinates; `covariance`: of
/// these. `integral` has laplaceColumns() and is whitened; afterwards it is at the minimum.
void describeLaplaceFit(const Design& design, const RandomStructure& structure, const ResponseFamily& family,
                        LaplaceIntegral& integral, const Minimum& minimum, const Eigen::MatrixXd& covariance,
                        const ResponseUnits& units, MixedModelFit& fit);
/// The restricted deviance, and what degrees of freedom need.
void addRestricted(const Design& design, const LaplaceIntegral& integral, const RestrictedOptimum& optimum,
                   const ResponseUnits& units, MixedModelFit& fit);

}  // namespace ocelli
