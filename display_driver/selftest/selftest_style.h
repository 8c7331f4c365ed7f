// The style sheet of the checklist for builders of displays.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kSelftestStyle;

}  // namespace ocelli
