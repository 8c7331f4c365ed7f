// The planned mixed model of right answers, and what stands beside it: checks, sizes, resampling, sensitivity.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of the trials that say whether their answer was right.
void addRightModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all);

}  // namespace ocelli
