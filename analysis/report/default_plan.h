// What is done with a study of which nobody registered a plan, by what its data hold.
#pragma once

#include "analysis/dataset/dataset.h"
#include "analysis/report/report_task.h"

namespace ocelli {

/// defaultPlan() of the study's conditions and tasks. Tables of other tools hold no forms, and no task that the rows of
/// the report know by chance alone: there forms ask nothing, and each task without a row has its usual models as
/// hypotheses, so that the report begins with what was found.
AnalysisPlan defaultPlanOf(const Dataset& data);

}  // namespace ocelli
