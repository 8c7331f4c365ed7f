// The mixed models of search times of a plan: table, checks, resampling, and the view's effect analysed in other ways.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Log-normal (of censored times too) or linear. `all`: searches with a time.
void addFindModel(ReportWork& work, const PlannedModel& model, const TrialList& all, TimeoutTreatment timeouts);

}  // namespace ocelli
