// Where lines of a paragraph end. Languages with spaces are cut at these, Chinese and Japanese between any two
// characters, but for signs that must not begin or end a line.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace ocelli {

/// Of each line its first character and the one after its last, without the spaces and the newline at its end.
/// `advance` is the width of a character. A word that is wider than a line is cut anywhere; no line is without a
/// character, but for those between two newlines.
std::vector<std::pair<size_t, size_t>> wrapLines(std::u32string_view text, double width,
                                                 const std::function<double(char32_t character)>& advance);

}  // namespace ocelli
