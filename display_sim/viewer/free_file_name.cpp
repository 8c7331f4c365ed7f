#include "display_sim/viewer/free_file_name.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "oc_core/base/error.h"

namespace ocelli {

std::filesystem::path makeFreeFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending) {
  constexpr int kMaxFiles = 1'000'000;
  for (int number = 1; number < kMaxFiles; ++number) {
    std::filesystem::path path = folder / fmt::format("{}-{:03}{}", stem, number, ending);
    if (std::FILE* file = std::fopen(path.c_str(), "wbx")) {  // x: fails where it exists
      std::fclose(file);
      return path;
    }
    if (errno != EEXIST) {
      throw WorkError(fmt::format("cannot write this file ({})", std::strerror(errno)), path.string(),
                      "start the viewer in a folder that is writable and has space");
    }
  }
  throw WorkError("there are a million files of this name", (folder / stem).string(), "move some elsewhere");
}

}  // namespace ocelli
