// Searches: how long they take, of which some were cut off by the limit.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

ReportTask findReportTask();

}  // namespace ocelli
