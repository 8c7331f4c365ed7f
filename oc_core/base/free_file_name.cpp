#include "oc_core/base/free_file_name.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

std::filesystem::path makeFreeFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending) {
  constexpr int kMaxFiles = 1'000'000;
  for (int number = 1; number < kMaxFiles; ++number) {
    const std::string digits = std::to_string(number);
    const std::string zeros(digits.size() < 3 ? 3 - digits.size() : 0, '0');
    std::filesystem::path path = folder / (stem + "-" + zeros + digits + ending);
    if (std::FILE* file = std::fopen(path.c_str(), "wbx")) {  // x: fails where it exists
      std::fclose(file);
      return path;
    }
    if (errno != EEXIST) {
      throw WorkError("cannot write this file (" + std::string(std::strerror(errno)) + ")", path.string(),
                      "choose a folder that is writable and has space");
    }
  }
  throw WorkError("there are a million files of this name", (folder / stem).string(), "move some elsewhere");
}

}  // namespace ocelli
