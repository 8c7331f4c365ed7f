// Where a model and the bootstrap disagree about the view, a reader should know: a model's interval is too short where
// its random effects leave out what differs, and the bootstrap's where there are few subjects or cases to draw from.
//
// The rule: one interval is less than two thirds as wide as the other, or one holds "no effect" and the other does not.
#pragma once

#include "analysis/inference/bootstrap.h"
#include "analysis/report/planned_model.h"

namespace ocelli {

/// The sentence of caution; empty where they agree, or one of them has no interval. `perUnit`: how much the model's
/// scale changes with one unit of the bootstrap's: 1 for log times, 1 / (p (1 - p)) for shares of right answers.
std::string resampledCaution(const Estimate& view, const Estimate& resampled, double perUnit);

void addResampledCaution(ReportWork& work, const PlannedModel& model, const Estimable<Estimate>& view,
                         const Estimable<BootstrapResult>& resampled, double perUnit);

}  // namespace ocelli
