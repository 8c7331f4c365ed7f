// The report as JSON, for programs: tables with the full values and sources of their cells.
#pragma once

#include <string>

#include "analysis/report/report_document.h"

namespace ocelli {

inline constexpr const char* kReportFormat = "ocelli-report-1";

/// {"format", "title", "version", "created", "elements": [{"type": "table", "id", "label", "part": "supplement",
/// "caption", "exploratory", "columns", "rows": [[{"text", "id", "value", "interval": [lower, upper], "short_name",
/// "source", "footnote"}]]}, ...], "row_sets": {"set-1": [{"file", "table", "rows": "1-5, 9"}]}, "cells": {ID:
/// {"rows": "set-1"} or {"from": [ID]} or {"subjects": number}}}. What is empty is left out: elements of the main
/// report have no "part". Values that are not finite are null. Figures come with title and description, not with their
/// image.
std::string jsonReport(const ReportDocument& document);

}  // namespace ocelli
