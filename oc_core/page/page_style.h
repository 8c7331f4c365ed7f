// The style sheet that all pages share: colours for light and dark screens, text, links, tables.
#pragma once

#include <string_view>

namespace ocelli {

extern const std::string_view kPageStyle;

}  // namespace ocelli
