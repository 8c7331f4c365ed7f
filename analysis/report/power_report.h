// The report of a power analysis: how many subjects, by which simulated studies, and what was supposed.
#pragma once

#include <string>

#include "analysis/report/power_study.h"
#include "analysis/report/report_document.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

/// Power and type-I error by subjects.
Figure powerStudyFigure(const PowerStudy& study);

ReportDocument powerReport(const PowerStudy& study, const std::string& version, const std::string& created);

}  // namespace ocelli
