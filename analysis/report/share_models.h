// What plans ask of shares of right answers beside a mixed model: whether the views are alike.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// The row with the p value of the test of equivalence, in the table of its model.
inline constexpr const char* kEquivalenceTestRow = "p of the two tests (the larger)";

/// Two one-sided tests against the bounds that the plan has for the task.
void addEquivalenceModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& trials);
void addBayesModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& trials);

}  // namespace ocelli
