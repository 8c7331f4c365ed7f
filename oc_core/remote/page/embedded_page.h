// The files of the page as they stand in this folder, put into the library when it is built (cmake/OcelliFiles.cmake).
#pragma once

#include <span>

#include "oc_core/base/embedded_file.h"

namespace ocelli {

std::span<const EmbeddedFile> embeddedPage();

}  // namespace ocelli
