// The likelihoods of mixed models as they are defined: whole matrices, and sums over fine grids. Slow, and plain to
// see.
#pragma once

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/censored_mixed_model.h"

namespace ocelli {

/// Z Lambda(theta) as one matrix, rows x random effects.
Eigen::MatrixXd denseRandomColumns(const std::vector<RandomTerm>& terms, const Eigen::VectorXd& theta);

/// -2 log likelihood of y ~ N(X beta, sigma^2 (Z Lambda Lambda' Z' + I)) at the best beta and sigma, or of the
/// restricted likelihood at the best sigma.
double denseGaussianDeviance(const Design& design, const Eigen::VectorXd& response, const Eigen::VectorXd& theta,
                             bool restricted);

/// -2 log likelihood with the integral over each level's effect as a sum over a grid. One term of intercepts.
double gridBinomialDeviance(const Design& design, const BinomialResponse& response, double theta,
                            const Eigen::VectorXd& coefficients);

/// The same of a response of which some rows are censored.
double gridCensoredDeviance(const Design& design, const CensoredResponse& response, double theta,
                            double residualDeviation, const Eigen::VectorXd& coefficients);

/// Laplace's approximation with a full Hessian.
double denseLaplaceDeviance(const Design& design, const BinomialResponse& response, const Eigen::VectorXd& theta,
                            const Eigen::VectorXd& coefficients);

}  // namespace ocelli
