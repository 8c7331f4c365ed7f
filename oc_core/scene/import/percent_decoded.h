// Names of files as URIs write them.
#pragma once

#include <string>

namespace ocelli {

/// The text with the byte that each %XX stands for in its place; where no two hexadecimal digits follow, % stays.
std::string percentDecoded(const std::string& text);

}  // namespace ocelli
