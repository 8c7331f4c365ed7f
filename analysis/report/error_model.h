// The mixed models of errors of a plan, of studies of two conditions: table, checks, resampling, and the view's effect
// analysed in other ways. Of other numbers of conditions conditions_section.h has them.
#pragma once

#include "analysis/report/estimate_trials.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/report_task.h"

namespace ocelli {

/// Those with an estimate and with all terms of the model.
TrialList trialsOfErrorModel(const PlannedModel& model, const TrialList& trials);
/// Of trialsOfErrorModel().
Estimable<PlannedFit> fitErrors(const PlannedModel& model, const TrialList& trials);

/// What a reader must know of the response: how errors of 0 count, and that a linear model does not know that
/// directions go around, where errors are large. Whole sentences.
std::vector<std::string> notesOfErrors(const PlannedModel& model, const TrialList& trials,
                                       const ErrorResponse& response);

void addErrorModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all);

}  // namespace ocelli
