// What the page of a report has beside the colours and fonts of all pages (oc_core/page/page_colors.h), and its script.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace ocelli
