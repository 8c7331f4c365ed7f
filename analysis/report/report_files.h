// What a report's folder holds.
#pragma once

#include <vector>

#include "analysis/report/report_document.h"
#include "analysis/report/report_folder.h"

namespace ocelli {

/// index.html and supplement.html, report.pdf and report.json, and figures/ID.svg and .pdf of each figure, to be taken
/// into a paper.
std::vector<ReportFile> reportFiles(const ReportDocument& document);

}  // namespace ocelli
