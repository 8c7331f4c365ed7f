// What the page of a report looks like, and its script.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kReportStyle;
extern const std::string_view kReportScript;

}  // namespace ocelli
