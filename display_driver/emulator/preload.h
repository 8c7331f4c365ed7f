// umockdev's library that programs preload which are to see emulated devices.
#pragma once

#include <string>

namespace ocelli {

inline constexpr const char* kPreloadLibrary = "libumockdev-preload.so.0";

/// For LD_PRELOAD: that library, and those that the user has preloaded.
std::string preloadList();

}  // namespace ocelli
