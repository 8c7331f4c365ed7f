// The screens that the study was shown on and how steadily, as far as the runs stored it; and what is not known.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addApparatus(ReportWork& work);

}  // namespace ocelli
