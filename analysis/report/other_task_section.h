// Tasks that have no row in report_task.h: how often answers are right and how long they take, by view, with the usual
// models.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// For a task of any name. Its models are a binomial mixed one of right answers and a log-normal mixed one of times,
/// each with the view and the session; the plan's own stand in for them where it has some.
ReportTask otherTask(const std::string& name);

}  // namespace ocelli
