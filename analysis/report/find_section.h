// Searches: how long they take, of which some were cut off by the limit.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addFindSection(ReportWork& work);

/// Seconds after which searches were ended: the longest of the trials, or that of section 7.4.2 where none says.
double searchLimit(const TrialList& trials);

}  // namespace ocelli
