// Thresholds of a task by condition, where staircases set the level of its stimulus: psychometric functions of
// subjects, and how conditions differ within them.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of trials of which some have a level.
void addThresholdSection(ReportWork& work, const ReportTask& task, const TrialList& trials);

}  // namespace ocelli
