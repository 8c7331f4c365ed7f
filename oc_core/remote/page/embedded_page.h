// The files of the page as they stand in this folder, put into the library when it is built (cmake/OcelliFiles.cmake).
#pragma once

#include <span>
#include <string_view>

namespace ocelli {

struct EmbeddedFile {
  std::string_view name;
  std::string_view bytes;
};

std::span<const EmbeddedFile> embeddedPage();

}  // namespace ocelli
