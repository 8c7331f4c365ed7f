// What linear, censored and binomial mixed models say in common, and what is asked of any of them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/models/design.h"
#include "analysis/models/minimum.h"
#include "analysis/models/random_structure.h"

namespace ocelli {

/// Residuals below this share of the response are rounding.
inline constexpr double kNoResiduals = 1e-9;

/// The random effects of one term.
struct RandomTermFit {
  std::string group;
  std::vector<std::string> levels;
  std::vector<std::string> names;      ///< of its effects
  Eigen::VectorXd standardDeviations;  ///< between levels, of each effect
  Eigen::MatrixXd covariance;          ///< effects x effects
  Eigen::MatrixXd correlations;        ///< likewise; 0 where a standard deviation is 0
  Eigen::MatrixXd effects;             ///< levels x effects: conditional modes, the best linear unbiased predictions
  Eigen::VectorXd relativeDeviations;  ///< standard deviations of what the effects add to a row, root mean square
  bool atBoundary = false;             ///< a variance is 0, or a correlation 1 or -1
};

/// Relative standard deviations below are those of a singular fit, and count as 0; lme4 draws the line there too.
inline constexpr double kSingularDeviation = 1e-4;

/// Whether the search for the optimum ended at one.
struct Convergence {
  bool converged = false;
  std::string reason;           ///< why not: a whole clause
  int evaluations = 0;          ///< of the deviance
  double expectedDecrease = 0;  ///< of the deviance by one more step
};

struct MixedModelFit {
  Eigen::Index rows = 0;
  std::vector<std::string> names;  ///< of the coefficients
  std::vector<DroppedColumn> dropped;
  Eigen::VectorXd coefficients;
  Eigen::VectorXd standardErrors;
  Eigen::MatrixXd covariance;  ///< of the coefficients
  std::vector<RandomTermFit> random;

  double deviance = 0;      ///< -2 log likelihood at the optimum; of the restricted likelihood where `restricted`
  bool restricted = false;  ///< REML
  int parameters = 0;       ///< coefficients and variances
  Eigen::VectorXd theta;    ///< relative covariance factors, term by term, as lme4 orders them

  // For degrees of freedom, where a method gives them: of theta, and of the residual standard deviation where there is
  // one.
  Eigen::MatrixXd varianceParameterCovariance;
  std::vector<Eigen::MatrixXd> covarianceGradients;  ///< of `covariance`, by each of these

  Convergence convergence;
  bool singular = false;
  std::vector<std::string> boundary;  ///< which variances are 0 and which correlations 1: whole clauses
  std::vector<std::string> warnings;  ///< all that a reader should know: no convergence, singular, dropped columns

  Eigen::VectorXd fitted;  ///< with random effects; probabilities for a binomial model
};

/// Where the coefficient of this name is; impossible where its column was dropped, or never there.
Estimable<Eigen::Index> coefficientIndex(const MixedModelFit& fit, const std::string& name);

/// -2 log of the ratio of two likelihoods, and its chi-squared p-value (`degreesOfFreedom`: how many parameters more).
/// Impossible for other rows, for restricted likelihoods of other fixed effects, and where the larger fits worse. Where
/// the smaller model has a variance less, the p-value is too large, by up to twice: 0 lies at the edge of what can be.
Estimable<Estimate> likelihoodRatio(const MixedModelFit& smaller, const MixedModelFit& larger);

/// contrast' beta, with t and the degrees of freedom of Satterthwaite's method, as Kuznetsova, Brockhoff, Christensen
/// 2017 have it (lmerTest, J. Stat. Softw. 82(13), section 2.2); with Wald's z for a binomial model by maximum
/// likelihood. There is never less than one degree of freedom, which is what two levels give: where the method says
/// less, the likelihood is so flat in the variances that its curvature tells nothing.
Estimate contrastEstimate(const MixedModelFit& fit, const Eigen::VectorXd& contrast, double level = 0.95);
Estimable<Estimate> coefficientEstimate(const MixedModelFit& fit, const std::string& name, double level = 0.95);

/// z: infinite degrees of freedom; t: `degreesOfFreedom`. `level` of the interval, 0.95. Without a
/// standard error, or degrees of freedom above 0, there is no interval and no test. An interval that has no ends in
/// floating point is infinite.
Estimate estimateOf(double value, double standardError, double degreesOfFreedom, double level);

// For the models.

/// Fills names, theta, random terms (`scaledTheta` and `b` of the structure; `variance` of the residuals, or 1), what
/// is singular, convergence and warnings.
void describeFit(const Design& design, const RandomStructure& structure, const Minimum& minimum,
                 const Eigen::VectorXd& scaledTheta, const Eigen::VectorXd& b, double variance, MixedModelFit& fit);

/// theta, the first values of `minimum`, without negative diagonals, and those that are nearly 0 set to 0 where the
/// deviance does not rise.
void settleAtBoundary(const RandomStructure& structure, const Objective& deviance, Minimum& minimum);

}  // namespace ocelli
