// Logistic mixed models of successes among trials, y ~ Binomial(n, 1 / (1 + exp(-(X beta + Z b)))), by maximum
// likelihood as laplace_integral.h has it. beta and theta are optimized together.
#pragma once

#include "analysis/models/mixed_model.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {

struct BinomialResponse {
  Eigen::VectorXd successes;  ///< whole numbers, 0 to trials
  Eigen::VectorXd trials;     ///< whole numbers, 1 or more
};

/// One trial a row.
BinomialResponse binaryResponse(const std::vector<bool>& successes);

/// `deviance` is -2 log likelihood, binomial coefficients included; the standard errors are Wald's, from its Hessian.
struct BinomialMixedFit : MixedModelFit {
  int quadraturePoints = 1;
  Eigen::VectorXd linearPredictor;  ///< with random effects
};

class LaplaceIntegral;
class ResponseFamily;

class BinomialMixedModel {
 public:
  explicit BinomialMixedModel(Design design);

  const Design& design() const { return design_; }

  /// `quadraturePoints`: 1 for Laplace's approximation; 2 to 25 where there is one random effect a level of one term,
  /// and otherwise InputError. Impossible, as a whole: no rows, one level of a grouping factor, equal responses, as
  /// many random effects as rows of one trial, answers that the columns separate (the reason names them: their
  /// coefficients are infinite, and those of others depend on how far one goes), and levels that differ without limit.
  /// A fit that did not converge, or is singular, says so itself. Throws InputError for a response that is no count
  /// of successes.
  Estimable<BinomialMixedFit> fit(const BinomialResponse& response, int quadraturePoints = 1) const;

  /// For few subjects or items: variances by the restricted likelihood (laplace_fit.h). Intervals are t's, with degrees
  /// of freedom by Satterthwaite's method.
  Estimable<BinomialMixedFit> fitRestricted(const BinomialResponse& response) const;

  /// What fit() minimises, at relative covariance factors in lme4's order, and coefficients.
  double deviance(const BinomialResponse& response, const Eigen::VectorXd& theta, const Eigen::VectorXd& coefficients,
                  int quadraturePoints = 1) const;

  /// Successes drawn from the fitted model, with random effects of their own.
  BinomialResponse simulate(const BinomialMixedFit& fit, const Eigen::VectorXd& trials, RandomNumbers& numbers) const;

 private:
  void check(const BinomialResponse& response, int quadraturePoints) const;
  std::optional<std::string> whyNot(const BinomialResponse& response) const;
  /// From theta and whitened coordinates; `covariance`: of these coordinates.
  Estimable<BinomialMixedFit> describe(const ResponseFamily& family, LaplaceIntegral& integral, const Minimum& minimum,
                                       const Eigen::MatrixXd& covariance) const;

  Design design_;
  RandomStructure structure_;
};

}  // namespace ocelli
