// Who came through the study, and what was left out (CONSORT 2010).
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Long logs are cut; exclusionLogCsv() has all of it.
void addFlowSection(ReportWork& work);

}  // namespace ocelli
