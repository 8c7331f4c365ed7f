// What the page of `ocelli evaluate` adds to the style sheet of the demo page.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kEvaluationStyle;

}  // namespace ocelli
