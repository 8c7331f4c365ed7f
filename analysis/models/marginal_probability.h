// What a binomial mixed model says in probabilities: of success in a condition, averaged over its rows and over new
// subjects and items (Agresti 2015, Foundations of Linear and Generalized Linear Models, section 9.4). A coefficient is
// a log odds ratio within a subject; these are what proportions estimate.
#pragma once

#include "analysis/models/binomial_mixed_model.h"

namespace ocelli {

/// Rows as they would be, such as all of them in the second view.
struct Condition {
  Eigen::MatrixXd fixed;            ///< rows x coefficients
  Eigen::VectorXd randomVariances;  ///< of the sum of the random effects in each row, logits squared
};

/// `fixed` and `random`: built as those of the model were, with other values. Throws InputError where they differ.
Condition conditionOf(const BinomialMixedModel& model, const BinomialMixedFit& fit, const FixedEffects& fixed,
                      const std::vector<RandomTerm>& random);

/// The mean probability over the rows. Interval and standard error by the delta method, the interval on the scale of
/// logits; the variances of the random effects count as known. No test.
Estimate averageProbability(const BinomialMixedFit& fit, const Condition& condition, double level = 0.95);

/// The first less the second, with z.
Estimate averageProbabilityDifference(const BinomialMixedFit& fit, const Condition& first, const Condition& second,
                                      double level = 0.95);

}  // namespace ocelli
