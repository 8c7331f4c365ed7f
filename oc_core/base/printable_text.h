// Text of a file, as it can be shown on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace ocelli {

/// UTF-8 text on one line: control characters (C0, DEL and C1) stand as escapes, like `\n`, `\x1b` and `\u009b`, so
/// that none can begin a line or steer the terminal.
std::string printableText(std::string_view text);

}  // namespace ocelli
