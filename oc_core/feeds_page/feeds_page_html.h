// The page around the image, and its script. For the .cpp files of this room.
#pragma once

#include <string>

namespace ocelli {

inline constexpr const char* kFeedsScriptPath = "/feeds.js";
inline constexpr const char* kFeedsStatusPath = "/feeds.json";
inline constexpr const char* kFeedsImagePath = "/image";

std::string feedsPageHtml(const std::string& title);
std::string feedsPageScript();

}  // namespace ocelli
