// Covariates from their means, in standard deviations, so that fits do not depend on units; and what the regressions
// here share besides. For .cpp files: the interfaces of the fits do without Eigen.
//
//   Huber 1967; White 1980; Lin and Wei 1989   the sandwich
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/covariate.h"
#include "analysis/inference/crossed_clusters.h"

namespace ocelli {

struct StandardizedCovariates {
  /// Throws InputError, naming `function`, where there is not one finite value a row.
  StandardizedCovariates(const std::vector<Covariate>& covariates, size_t rows, const char* function);

  /// Why these cannot all have a coefficient of their own, from the information on them; empty where they can.
  std::string whyNotIndependent(const Eigen::MatrixXd& information) const;

  std::vector<std::string> names;
  Eigen::MatrixXd values;  ///< rows x covariates
  Eigen::VectorXd mean;
  Eigen::VectorXd scale;
  std::string problem;  ///< why there is nothing to fit: no rows, no covariates, one that does not vary; else empty
};

/// Of coefficients whose model covariance is `model`, from a row of score residuals a trial. No factor for few
/// clusters: cluster_jackknife.h is for these.
Eigen::MatrixXd sandwich(const Eigen::MatrixXd& scoreResiduals, const Eigen::MatrixXd& model,
                         const DenseLabels& clusters);
/// Likewise, with clusters that cross these where there are some.
Eigen::MatrixXd sandwich(const Eigen::MatrixXd& scoreResiduals, const Eigen::MatrixXd& model,
                         const CrossedClusters& clusters);
/// byFirst + bySecond - byBoth, of which the last two count in directions alone where they add.
Eigen::MatrixXd withCrossed(const Eigen::MatrixXd& byFirst, const Eigen::MatrixXd& bySecond,
                            const Eigen::MatrixXd& byBoth);

std::vector<std::vector<double>> rowsOf(const Eigen::MatrixXd& matrix);

/// Whether a likelihood has become flat in some direction of the coefficients, where it grows without bound: its
/// `information` is next to nothing of `reference`, which is what it would be with no effects. Which coefficient has
/// most of that direction.
std::optional<size_t> flatDirection(const Eigen::MatrixXd& information, const Eigen::MatrixXd& reference);

/// The reason why robust errors cannot be estimated.
std::string fewClusters(const CrossedClusters& clusters, size_t coefficients);

}  // namespace ocelli
