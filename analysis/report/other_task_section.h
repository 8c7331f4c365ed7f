// Tasks that have no row in report_task.h: how often answers are right and how long they take, by view, with the usual
// models; and what measures of their trials tell (measure_sections.h).
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// For a task of any name. Its models are mixed ones with the view, and the session where there are several: a binomial
/// one of right answers and a log-normal one of times; where answers are estimates, of signed and of absolute errors in
/// place of right answers; where staircases set the level, of times alone, as they hold the share of right answers
/// where they want it. The plan's own stand in for them where it has some.
ReportTask otherTask(const std::string& name, const TaskMeasures& measures = {});

}  // namespace ocelli
