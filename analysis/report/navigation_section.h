// How subjects moved while they searched: ways, sight, turns and standing by view, and where in the maze the time went.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// Reads the logs of all trials of the task, which are searches.
void addNavigationSection(ReportWork& work, const ReportTask& task);

}  // namespace ocelli
