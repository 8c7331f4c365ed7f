// What a report was made from: program, plan, files, protocols and their hashes. It stands in the supplement.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addProvenance(ReportWork& work, const std::string& version);

}  // namespace ocelli
