// The hypotheses of the plan with their corrected p values, and a paragraph on methods.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// After all sections that test something.
void addHypotheses(ReportWork& work);
void addMethods(ReportWork& work, const std::string& version);

}  // namespace ocelli
