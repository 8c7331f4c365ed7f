// The report as an HTML page, index.html, and its supplement as another, supplement.html. Beside each other they need
// nothing else: no network, no fonts, no script to be read.
#pragma once

#include <string>

#include "analysis/report/report_document.h"

namespace ocelli {

/// A policy in the page forbids whatever it does not hold itself. Its one small script adds a button that copies
/// excerpts, and shows a cell's source on a tap.
std::string htmlReport(const ReportDocument& document);
/// The supplement, and where the numbers of all tables come from.
std::string htmlSupplement(const ReportDocument& document);

}  // namespace ocelli
