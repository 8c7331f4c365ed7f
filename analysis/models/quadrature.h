// Gauss-Hermite quadrature by the eigenvalues of a tridiagonal matrix (Golub and Welsch 1969).
#pragma once

#include <Eigen/Core>

namespace ocelli {

/// The integral of f(x) exp(-x^2) over all x is the sum of weights[k] f(points[k]), exact for polynomials of degree
/// 2 points - 1.
struct HermiteRule {
  Eigen::VectorXd points;
  Eigen::VectorXd weights;
};

/// `count`: 1 or more.
HermiteRule hermiteRule(int count);

}  // namespace ocelli
