// The columns of a planned model, and which of its random effects are fitted.
//
// A plan names random effects before there are data, and not all data can tell them. What is fitted follows from these
// steps; the report tells each slope that is left out, and why.
//
//   0. Correlations between intercepts and slopes are not fitted: a dozen subjects or cases cannot tell them, and tests
//      hold their level without them where columns are centered (Barr, Levy, Scheepers, Tily 2013, Random effects
//      structure for confirmatory hypothesis testing, J. Mem. Lang. 68(3)).
//   By the design, before any response is looked at:
//   1. A slope stays where three or more levels of the group have two or more trials at each of two values of its
//      term: a case is seen in both views. Otherwise levels do not show how they differ in it.
//   2. Slopes of a group stay where its random effects are fewer than the trials.
//   By the fit, from there on, until nothing is left to do:
//   3. Where the search does not converge, the slope goes that adds least to the variance of a trial.
//   4. The slope goes without which the restricted deviance rises least, where that is by less than 0.455: a likelihood
//      ratio of a variance at its boundary has p > 0.25 then (Self and Liang 1987). A variance of 0 is such a one.
//
// Why 0.25: where nothing differs in the view's effect, slopes that are kept all the same make tests of few subjects
// and cases reject 2 % and not 5 %; where little differs, a rule that keeps them below p = 0.05 alone leaves out what
// matters and rejects up to 12 %. In balanced designs of normal responses, 5 to 45 subjects, 8 to 40 cases and any
// deviations, it is 3 to 7 % at 0.2 and 2 to 6 % at 0.3 (the idea, and 0.2, are those of Matuschek, Kliegl, Vasishth,
// Baayen, Bates 2017, Balancing Type I error and power in linear mixed models, J. Mem. Lang. 94).
#pragma once

#include <optional>

#include "analysis/models/mixed_model.h"
#include "analysis/report/report_parts.h"

namespace ocelli {

/// The columns of the terms; all trials have a value of each.
FixedEffects plannedColumns(const PlannedModel& model, const TrialList& trials, bool intercept);
/// The first column of a term, "view=other"; empty where there is none.
std::string columnOf(const FixedEffects& fixed, const std::string& term);

/// Of a restricted deviance, below which a slope is left out: the quantile of chi-squared with one degree of freedom
/// that half lie above.
inline constexpr double kMinDevianceRise = 0.4549;

struct FittedStructure {
  std::vector<RandomEffect> effects{};
  std::vector<std::string> reasons{};  ///< what of the plan was left out and why: whole clauses
};

/// Steps 1 and 2.
FittedStructure structureByDesign(const PlannedModel& model, const TrialList& trials);

/// A slope of a structure.
struct SlopePlace {
  size_t effect = 0;
  size_t slope = 0;
};
/// Those by cases come first.
std::vector<SlopePlace> slopesOf(const FittedStructure& structure);
FittedStructure withoutSlope(const FittedStructure& structure, const SlopePlace& place, const std::string& why);
/// What the slope adds to a trial: RandomTermFit::relativeDeviations.
double relativeDeviation(const MixedModelFit& fit, const SlopePlace& place);
/// Whether its standard deviation is more than four standard errors from 0: the deviance rises by about 4 without it,
/// so that it need not be fitted again to know that it stays.
bool isClear(const MixedModelFit& fit, const SlopePlace& place);

/// "(1 + view || subject) + (1 | case)", as lme4 writes it; "||": without correlations.
std::string structureText(const std::vector<RandomEffect>& effects);

Design plannedDesign(const PlannedModel& model, const TrialList& trials, const FittedStructure& structure);

}  // namespace ocelli
