// Mixed models of a study with several conditions, and what they say of conditions and contrasts.
//
// Random effects of a plan: an intercept of each subject or case, and slopes. A slope of a number is one more random
// effect of a level. A slope of conditions, or of a factor, is an intercept of each subject (or case) in each
// condition, with one variance: "(1 | subject) + (1 | subject:view)". So all contrasts of conditions are alike,
// whichever condition comes first; slopes of the columns of a factor with several levels would not be. For two
// conditions it is the model of planned_design.h with another parametrisation: differences by subject have twice that
// variance.
//
// Slopes are left out as planned_design.h has it: by the design (three or more levels of the group with two or more
// trials in each of two conditions; fewer effects than trials), and by the fit, where the restricted deviance rises by
// less than kMinDevianceRise without it, or where the search does not converge with it.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/report/contrast_weights.h"

namespace ocelli {

struct ContrastEstimate {
  PlannedContrast contrast;
  Estimable<Estimate> estimate;  ///< on the model's own scale: log seconds, logits, errors
};

/// Of a term with one column, which is no condition: "session".
struct CovariateEstimate {
  std::string term;
  Estimable<Estimate> estimate;
};

struct ConditionFit {
  std::vector<Estimable<Estimate>> means;  ///< of each condition, on the model's own scale
  std::vector<ContrastEstimate> contrasts;
  std::vector<CovariateEstimate> covariates;
  std::string structure;             ///< random effects that were fitted, as lme4 writes them
  std::vector<std::string> random;   ///< "subject:view: standard deviation 0.21"
  std::vector<std::string> leftOut;  ///< what of the planned ones was left out and why: whole clauses
  std::vector<std::string> warnings;
  std::string search;                ///< how the search for the optimum ended: a whole clause
  TrialList trials;                  ///< that were used
  std::vector<std::string> notes{};  ///< what a reader must know of its response: whole sentences
  bool warned() const { return !warnings.empty(); }
};

/// The trials are those of the task; which of them the model takes follows from its kind, its terms and `timeouts`.
/// Impossible, with the reason, where there is no such fit.
Estimable<ConditionFit> fitConditions(const Dataset& data, const PlannedModel& model, const TrialList& trials,
                                      TimeoutTreatment timeouts, const std::vector<PlannedContrast>& contrasts);

/// "(1 | subject) + (1 | subject:view)".
std::string conditionStructureText(const std::vector<RandomEffect>& effects);

}  // namespace ocelli
