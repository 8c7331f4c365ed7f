// What practice does: times and right answers from session to session, and within the blocks of a session.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

/// `tasks` of "find", "count", "path".
void addLearningSection(ReportWork& work, const std::vector<std::string>& tasks);

}  // namespace ocelli
