// Whether those who came to all sessions were different from the start.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of tasks that have trials.
void addCompletersSection(ReportWork& work, const std::vector<ReportTask>& tasks);

}  // namespace ocelli
