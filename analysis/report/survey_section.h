// What subjects say of the views.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addSurveySection(ReportWork& work);

}  // namespace ocelli
