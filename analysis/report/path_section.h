// Paths: whether they are recognised equally well in both views, and better than by guessing.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

ReportTask pathReportTask();

/// How often a guess is right: by the maps that the protocol has for the task, or those of section 7.4.4 where none
/// says.
double chanceOf(const Dataset& data, const std::string& task);

}  // namespace ocelli
