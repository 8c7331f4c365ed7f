// The mixed models of times of a plan: table, checks, resampling, and the view's effect analysed in other ways.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// Log-normal (of censored times too) or linear, of the trials that have a time.
void addTimeModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all);

}  // namespace ocelli
