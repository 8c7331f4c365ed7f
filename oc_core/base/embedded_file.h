// A text file of the source tree that stands in a library (cmake/OcelliFiles.cmake).
#pragma once

#include <string_view>

namespace ocelli {

struct EmbeddedFile {
  std::string_view name;
  std::string_view bytes;
};

}  // namespace ocelli
