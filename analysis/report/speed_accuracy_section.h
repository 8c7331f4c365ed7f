// Speed against accuracy: how long answers take and how many are right, of each subject in each condition, and whether
// right answers take longer than wrong ones. A condition that only makes people slower and more careful shows here.
#pragma once

#include <vector>

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of tasks whose outcome is not the time itself; for any number of conditions.
void addSpeedAccuracySection(ReportWork& work, const std::vector<ReportTask>& tasks);

}  // namespace ocelli
