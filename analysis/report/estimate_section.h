// Estimates of a task by condition: bias and absolute error, of lengths how they are compressed, of directions circular
// statistics; time-outs are missing estimates, and counted.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of trials of which some hold an estimate.
void addEstimateSection(ReportWork& work, const ReportTask& task, const TrialList& trials);

}  // namespace ocelli
