// Counts: how often they are right, and how far off.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

ReportTask countReportTask();

}  // namespace ocelli
