// Times of searches, as the methods of survival take them.
#pragma once

#include "analysis/dataset/analysis_plan.h"
#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/survival_data.h"
#include "analysis/tables/table_cells.h"

namespace ocelli {

bool isCensored(const Trial* trial);
/// "censored", "removed", "set to the limit".
const char* labelOf(TimeoutTreatment timeouts);
TrialList withoutTimeouts(TrialList trials);
/// Seconds after which searches were ended: the longest of the trials, or that of section 7.4.2 where none says.
double searchLimit(const TrialList& trials);
std::vector<bool> areOther(const TrialList& trials);
std::vector<SurvivalTime> timesOf(const TrialList& trials, TimeoutTreatment timeouts);

/// Whether cases are among what a model takes as drawn from more.
bool namesCases(const PlannedModel& model);

/// What Cox and log-normal regressions of the plan are given: errors are robust to subjects, and to cases where the
/// model names them, for few of either.
SurvivalData survivalDataOf(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts);

/// other less reference, in seconds up to the limit; subjects and cases are clusters.
Estimable<RestrictedMeanDifference> restrictedMeanDifferenceOf(const TrialList& trials, TimeoutTreatment timeouts,
                                                               double limit);

}  // namespace ocelli
