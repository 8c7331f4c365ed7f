// Comma-separated values as RFC 4180 has them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// A field of a line: in quotes where it holds a comma, a quote or a line break. What a spreadsheet would take for a
/// formula (it begins with =, +, -, @, a tab or a carriage return) gets a ' in front. Bytes that are no UTF-8 become
/// U+FFFD.
std::string csvText(std::string_view text);

/// The lines of a file, each as its fields. Takes LF and CRLF. Throws InputError, naming `where`, for quotes that do
/// not close.
std::vector<std::vector<std::string>> csvLines(std::string_view bytes, const std::string& where);

}  // namespace ocelli
