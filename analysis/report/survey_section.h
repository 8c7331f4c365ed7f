// What subjects say of the views.
#pragma once

#include "analysis/report/report_task.h"

namespace ocelli {

/// The table whose p values the test of the survey is made of.
inline constexpr const char* kSurveyTestsTable = "survey-preference";

ReportTask surveyReportTask();

}  // namespace ocelli
