// Counts: how often they are right, and how far off.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addCountSection(ReportWork& work);

}  // namespace ocelli
