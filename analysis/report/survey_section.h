// What subjects say of the views.
#pragma once

#include "analysis/dataset/form_item.h"
#include "analysis/report/report_task.h"

namespace ocelli {

/// The table whose p values the test of the survey is made of.
inline constexpr const char* kSurveyTestsTable = "survey-preference";

ReportTask surveyReportTask();

/// A table of what was answered, each question on its own scale, and notes on answers that are none of the options.
void addItemDescriptions(ReportWork& work, const std::vector<ItemAnswers>& items, const std::string& id,
                         const std::string& caption);

}  // namespace ocelli
