// Paths: whether they are recognised equally well in both views, and better than by guessing.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

void addPathSection(ReportWork& work);

}  // namespace ocelli
