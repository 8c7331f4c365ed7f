// Searches: how long they take, of which some were cut off by the limit.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addFindSection(ReportWork& work);

}  // namespace ocelli
