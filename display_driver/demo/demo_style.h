// The style sheet of the demo page.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kDemoStyle;

}  // namespace ocelli
