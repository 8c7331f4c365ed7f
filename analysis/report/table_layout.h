// Tables on pages: columns as wide as their cells need or as the page lets them, and the head again on every page.
#pragma once

#include <vector>

#include "analysis/report/page_flow.h"
#include "analysis/report/report_document.h"

namespace ocelli {

struct TableLayout {
  double size = 8.5;             ///< of its text, points; smaller where it would not fit
  std::vector<double> widths{};  ///< of columns, padding included
};

/// Within `width`: the largest text at which columns without words need no breaks; at the smallest, all are broken.
TableLayout layOut(const ReportTable& table, double width);

/// The table in as many as it takes for numbers to stand unbroken, each with the first column.
std::vector<ReportTable> partsOf(const ReportTable& table, double width);

/// Rows are not parted. Where a table goes on, its head stands again with "(continued)".
void flowTable(PageFlow& flow, const ReportTable& table, const ElementName& name);

}  // namespace ocelli
