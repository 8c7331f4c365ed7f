// How estimates of lengths grow with the truth: estimate = a * truth^exponent (Stevens 1957; of distances Da Silva
// 1985, Scales for perceived egocentric distance in a large open field, Am. J. Psychol. 98(1)), by a mixed model of
//   log estimate ~ condition + condition : log truth
// with intercepts and slopes that vary over subjects and over subjects in each condition, and intercepts that vary over
// cases and over cases in each condition: an exponent is told by how cases differ.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/report/estimate_trials.h"
#include "study/trial/view_condition.h"

namespace ocelli {

struct PowerLaw {
  Estimable<Estimate> exponent = Estimable<Estimate>::impossible("the condition has no trials");
  Estimable<Estimate> logAtCenter = Estimable<Estimate>::impossible("the condition has no trials");
  /// Of exponents, less that of the first condition.
  Estimable<Estimate> difference = Estimable<Estimate>::impossible("it is the first condition");
};

struct PowerLawFit {
  std::vector<PowerLaw> conditions;  ///< in their order
  double logCenter = 0;              ///< mean log truth of the trials
  std::string structure;             ///< of random effects, as lme4 writes it
  std::vector<std::string> warnings;
  TrialList trials;
};

/// Of lengths. Impossible where all truths are the same, and where no mixed model can be fitted.
Estimable<PowerLawFit> fitPowerLaw(const ViewConditions& conditions, const EstimateTrials& estimates);

}  // namespace ocelli
