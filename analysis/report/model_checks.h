// Whether what a planned model supposes holds, as figures.
#pragma once

#include "analysis/report/planned_model.h"

namespace ocelli {

/// Standardised residuals against fitted values and normal quantiles, and random effects against normal quantiles.
void addLinearChecks(ReportWork& work, const PlannedModel& model, const PlannedFit& fit,
                     const std::string& fittedLabel = "Fitted log seconds");
/// Binned residuals of right answers, and random effects. `trials`: those that were fitted.
void addBinomialChecks(ReportWork& work, const PlannedModel& model, const TrialList& trials, const PlannedFit& fit);

}  // namespace ocelli
