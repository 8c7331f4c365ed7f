// The tables of chapter 7 of Rosen 2010 in a report.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addPaperSection(ReportWork& work, const std::vector<Table>& tables);

}  // namespace ocelli
