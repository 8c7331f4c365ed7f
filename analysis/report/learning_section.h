// What practice does: times and right answers from session to session, and within the blocks of a session.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_task.h"

namespace ocelli {

/// Of tasks that have trials.
void addLearningSection(ReportWork& work, const std::vector<ReportTask>& tasks);

}  // namespace ocelli
