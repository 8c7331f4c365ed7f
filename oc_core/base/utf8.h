// Text that every writer can take, whatever a database holds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// Valid UTF-8 of characters that XML 1.0 allows: invalid bytes, and control characters other than tab and newline,
/// become U+FFFD.
std::string cleanText(std::string_view text);

/// 0 where the text is empty, or does not begin with a character in its shortest form.
size_t bytesOfFirstCharacter(std::string_view text);

/// Of UTF-8: bytes that continue a character do not count.
size_t characterCount(std::string_view text);

/// Of clean text.
std::vector<char32_t> codePoints(std::string_view text);
std::string utf8FromCodePoint(char32_t code);

}  // namespace ocelli
