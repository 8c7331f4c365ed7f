// The planned mixed model of right answers, and what stands beside it: checks, sizes, resampling, sensitivity. Counts
// and paths have it in common.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// `caption`: of the table of odds ratios.
void addRightModel(ReportWork& work, const PlannedModel& model, const TrialList& trials, const std::string& caption);

}  // namespace ocelli
