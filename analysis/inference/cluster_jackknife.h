// Covariances of coefficients from what they become without one cluster of trials after the other, for few clusters: a
// sandwich takes the residuals for errors, which are smaller, most so where few clusters determine a coefficient.
//
//   Lipsitz, Dear and Zhao 1994, Biometrics 50(3)          regressions of times, a single Newton step for each cluster
//   Bell and McCaffrey 2002, Surv. Methodol. 28(2)         that it takes off the bias of few clusters ("CR3")
//   Cameron, Gelbach and Miller 2011, section 2            clusters that cross each other
//   Satterthwaite 1946; Clark 1973, J. Verbal Learn. 12    degrees of freedom of such a sum, as of the quasi F ratio
//
// DEVIATION: trials that share both clusters are many, and theirs is a plain sandwich. What the second clusters add
// counts where it is positive only, as crossed_clusters.h has it. Degrees of freedom are never fewer than those of the
// fewer clusters: the sum errs upwards where Satterthwaite's are fewer (docs/results.md has what came of it).
//
// For .cpp files, as standardized_covariates.h.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "analysis/inference/crossed_clusters.h"

namespace ocelli {

/// What trials tell of the coefficients at the maximum of the likelihood.
struct TrialShares {
  Eigen::MatrixXd scores;       ///< trials x coefficients; columns sum to 0
  Eigen::MatrixXd information;  ///< coefficients x coefficients, in all trials; positive definite
  /// Likewise, in some trials.
  std::function<Eigen::MatrixXd(const std::vector<size_t>& trials)> informationIn;
};

struct JackknifeCovariance {
  Eigen::MatrixXd covariance;
  // What it is the sum of, the trials that share both aside.
  Eigen::MatrixXd byFirst;
  Eigen::MatrixXd bySecond;  ///< empty without second clusters
  /// Of a coefficient, for Student's t. `clusters` are those that it was made from.
  double degreesOfFreedom(Eigen::Index coefficient, const CrossedClusters& clusters) const;
  /// Of other coefficients: `map` times these.
  JackknifeCovariance mapped(const Eigen::MatrixXd& map) const;
};

/// Without second clusters, those by the first ones. Factors are (clusters - 1) / clusters. What the other clusters do
/// not tell of at all does not change without a cluster: restOnOneCluster() names these coefficients.
JackknifeCovariance jackknifeCovariance(const TrialShares& shares, const CrossedClusters& clusters);

/// For each covariate (a column), whether it has a coefficient of its own only thanks to one of the clusters: then how
/// far that varies between clusters is not known.
std::vector<bool> restOnOneCluster(const Eigen::MatrixXd& covariates, const CrossedClusters& clusters);

}  // namespace ocelli
