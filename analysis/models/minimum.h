// The least value of a smooth function of a few numbers, and whether it is one: BOBYQA (Powell 2009, through NLopt)
// comes near, Newton steps with differences for derivatives end the search, and the Hessian there tells a minimum from
// what merely stopped.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace ocelli {

using Objective = std::function<double(const Eigen::VectorXd&)>;

struct MinimumSearch {
  double firstStep = 0.5;         ///< of BOBYQA
  double lastStep = 1e-3;         ///< at which Newton steps take over
  double gradientStep = 1e-4;     ///< of differences
  double hessianStep = 2e-3;      ///< likewise
  double hessianReach = 1e-4;     ///< the Hessian is that of the minimum if it was found within this distance
  double wantedDecrease = 1e-10;  ///< a Newton step would lower the value by no more than this at the minimum
  double allowedDecrease = 1e-6;  ///< or by this where rounding stops the search: more is no convergence
  int maxEvaluations = 5000;
};

struct Minimum {
  Eigen::VectorXd point;
  double value = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
  bool converged = false;
  std::string reason;  ///< why not: a whole clause
  int evaluations = 0;
  double expectedDecrease = 0;  ///< by a Newton step from here
};

/// BOBYQA alone: within about search.lastStep of a minimum.
Eigen::VectorXd nearMinimum(const Objective& objective, const Eigen::VectorXd& start, const MinimumSearch& search);

/// Searches from `start`; from other points too where that ends at no minimum, and then returns the best of them.
Minimum findMinimum(const Objective& objective, const Eigen::VectorXd& start, const MinimumSearch& search);

/// 2 / hessian over the directions in which the function curves: the covariance of what minimises a deviance. Nothing
/// in flat directions, about which the function says nothing.
Eigen::MatrixXd covarianceOfMinimum(const Eigen::MatrixXd& hessian);

}  // namespace ocelli
