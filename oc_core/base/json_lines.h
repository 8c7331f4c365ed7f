// On which line of a JSON text each of its values stands: the parser does not tell.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace ocelli {

/// The JSON pointer (RFC 6901) of a field of the object at `pointer`.
std::string pointerToField(const std::string& pointer, std::string_view name);
/// The same of an element of an array.
std::string pointerToElement(const std::string& pointer, size_t index);

/// Lines from 1, by JSON pointer: of a field that of its name, of an element that of its value. `text` must
/// have been parsed before; comments are allowed.
std::map<std::string, int> linesOfJson(std::string_view text);

/// Where in the text the value at a pointer stands: its first byte, and the one behind its last. (0, 0) where there is
/// none. `text` must have been parsed before.
std::pair<size_t, size_t> bytesOfJson(std::string_view text, const std::string& pointer);

}  // namespace ocelli
