// Whether those who came to all sessions were different from the start.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

/// `tasks` of "find", "count", "path".
void addCompletersSection(ReportWork& work, const std::vector<std::string>& tasks);

}  // namespace ocelli
