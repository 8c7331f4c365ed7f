// Linear mixed models y = X beta + Z b + residual by (restricted) maximum likelihood: the profiled deviance of Bates,
// Maechler, Bolker, Walker 2015, Fitting linear mixed-effects models using lme4, J. Stat. Softw. 67(1), section 3.4,
// equations 34 and 41. Rows are summed up once; what a deviance costs then depends on the levels, not on the rows.
#pragma once

#include <cstdint>

#include "analysis/models/mixed_model.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {

struct LinearMixedFit : MixedModelFit {
  double residualDeviation = 0;
  Eigen::VectorXd residuals;  ///< from the fitted values with random effects
};

class LinearMixedModel {
 public:
  explicit LinearMixedModel(Design design);

  const Design& design() const { return design_; }

  /// One value a row. Impossible: no rows, one level of a grouping factor, as many random effects as rows, equal
  /// responses, or such as the effects reproduce exactly. A fit that did not converge, or is singular, says so itself.
  /// Throws InputError for a response that is not finite or of another length.
  Estimable<LinearMixedFit> fit(const Eigen::VectorXd& response, bool restricted = true) const;

  /// The profiled deviance at relative covariance factors `theta`, in lme4's order: what fit() minimises.
  double deviance(const Eigen::VectorXd& response, const Eigen::VectorXd& theta, bool restricted) const;

  /// A response drawn from the fitted model, with random effects of its own.
  Eigen::VectorXd simulate(const LinearMixedFit& fit, RandomNumbers& numbers) const;

 private:
  class Profile;

  Design design_;
  RandomStructure structure_;
  Eigen::VectorXd crossProduct_;  ///< Z'Z
  Eigen::MatrixXd randomFixed_;   ///< Z'Q, Q the orthonormal basis of the fixed effects
};

}  // namespace ocelli
