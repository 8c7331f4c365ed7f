// How subjects moved while they searched: ways, sight, turns and standing by view, and where in the maze the time went.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Reads the logs of all searches.
void addNavigationSection(ReportWork& work);

}  // namespace ocelli
