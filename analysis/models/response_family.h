// What the responses of a mixed model are, given their linear predictors: the part of the likelihood in which binomial
// and censored models differ. Each row has a log density that is concave in its predictor, so that the mode of the
// random effects is found by Newton's method (laplace_integral.h).
#pragma once

#include <Eigen/Core>

namespace ocelli {

class ResponseFamily {
 public:
  virtual ~ResponseFamily() = default;

  /// How many numbers the density has beside the predictor, such as the logarithm of a residual standard deviation.
  virtual Eigen::Index parameterCount() const { return 0; }
  virtual void setParameters(const Eigen::VectorXd& /*values*/) {}
  /// What theta is relative to: the residual standard deviation, or 1 where there is none.
  virtual double scale() const { return 1; }

  /// Fills what stands below.
  virtual void evaluate(const Eigen::VectorXd& predictor) = 0;
  virtual double logDensity(Eigen::Index row, double predictor) const = 0;

  // At the predictor of the last evaluate(), less what no predictor changes (constant()).
  double deviance() const { return deviance_; }              ///< -2 log density of all rows
  const Eigen::VectorXd& slopes() const { return slopes_; }  ///< first derivative of the log density of each row
  const Eigen::VectorXd& curvatures() const { return curvatures_; }  ///< less the second one: not negative
  /// Of the deviance, at these parameters; logDensity() lacks it too.
  double constant() const { return constant_; }

 protected:
  double deviance_ = 0;
  double constant_ = 0;
  Eigen::VectorXd slopes_{};
  Eigen::VectorXd curvatures_{};
};

}  // namespace ocelli
