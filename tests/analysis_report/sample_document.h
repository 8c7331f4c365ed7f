// A document with every kind of element, of made-up data: for tests, and to look at (report_gallery).
#pragma once

#include "analysis/report/report_document.h"

namespace ocelli {

ReportDocument sampleDocument();

/// Every text that a database could hold is an attack.
ReportDocument hostileDocument();

}  // namespace ocelli
