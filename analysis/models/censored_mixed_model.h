// Linear mixed models of a response that is known only to be larger in some rows: y ~ N(X beta + Z b, sigma^2), and a
// censored row adds the probability of what lies above its value. Of the logarithm of times this is the log-normal
// survival model with random effects (Kalbfleisch and Prentice 2002, chapter 3; Vaida and Liu 2009, J. Comput. Graph.
// Stat. 18(4), section 2). The integral over b is that of laplace_integral.h, which is exact where no row is censored:
// then this is the linear mixed model.
#pragma once

#include "analysis/models/mixed_model.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {

struct CensoredResponse {
  Eigen::VectorXd values;      ///< of a censored row: what the response lies above
  std::vector<bool> censored;  ///< one a row
};

/// `varianceParameterCovariance` is that of theta and of the logarithm of the residual standard deviation.
struct CensoredMixedFit : MixedModelFit {
  double residualDeviation = 0;
  /// From the fitted values with random effects; of a censored row, the mean of what the model expects above its value.
  Eigen::VectorXd residuals;
  int censoredRows = 0;
};

class LaplaceIntegral;

class CensoredMixedModel {
 public:
  explicit CensoredMixedModel(Design design);

  const Design& design() const { return design_; }

  /// By the restricted likelihood (laplace_fit.h), with Satterthwaite's degrees of freedom. Impossible: as a linear
  /// mixed model is; where all rows are censored; where the fixed effects reproduce the rows that are not exactly; and
  /// where some combination of conditions has censored rows alone (the reason names the coefficients, which are
  /// infinite). A fit that did not converge, or is singular, says so itself. Throws InputError for a response that
  /// is not finite or of another length.
  Estimable<CensoredMixedFit> fitRestricted(const CensoredResponse& response) const;

  /// -2 log likelihood at relative covariance factors in lme4's order, residual standard deviation, and coefficients.
  /// `quadraturePoints`: 1 for Laplace's approximation; more, up to 25, where there is one random effect a level of one
  /// term.
  double deviance(const CensoredResponse& response, const Eigen::VectorXd& theta, double residualDeviation,
                  const Eigen::VectorXd& coefficients, int quadraturePoints = 1) const;
  /// With the integral over the coefficients too, by Laplace's approximation: what fitRestricted() minimises.
  double restrictedDeviance(const CensoredResponse& response, const Eigen::VectorXd& theta,
                            double residualDeviation) const;

 private:
  void check(const CensoredResponse& response) const;
  std::optional<std::string> whyNot(const CensoredResponse& response) const;

  Design design_;
  RandomStructure structure_;
};

}  // namespace ocelli
