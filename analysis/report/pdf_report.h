// The report as PDF: A4, with contents, bookmarks and links, figures as vectors, and the sources of its numbers at the
// end.
#pragma once

#include <string>

#include "analysis/report/report_document.h"
#include "oc_core/drawing/pdf_file.h"

namespace ocelli {

std::string pdfReport(const ReportDocument& document);

/// The same before it becomes bytes: its pages.
PdfDocument pdfPages(const ReportDocument& document);

}  // namespace ocelli
