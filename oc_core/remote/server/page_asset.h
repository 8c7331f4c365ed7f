// A file of the page that the server hands out.
#pragma once

#include <string>

namespace ocelli {

struct PageAsset {
  std::string path;       ///< "/" is the page itself, "/remote.js" a script that it loads
  std::string mediaType;  ///< "text/html; charset=utf-8"
  std::string bytes;
};

}  // namespace ocelli
