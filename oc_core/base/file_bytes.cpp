#include "oc_core/base/file_bytes.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

void writeFile(const std::filesystem::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

std::string readFile(const std::filesystem::path& path, size_t maxBytes) {
  const auto fail = [&path](int reason) {
    throw InputError(std::string("cannot read this file (") + std::strerror(reason) + ")", path.string(),
                     "check the path and your rights");
  };
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    fail(errno);
  }
  // A device may have no end.
  struct stat status {};
  const bool isRegular = fstat(fileno(file.get()), &status) == 0 && S_ISREG(status.st_mode);
  if (!isRegular) {
    maxBytes = std::min(maxBytes, kMaxTextBytes);
  }
  std::string bytes;
  std::array<char, 1 << 16> block;
  for (size_t got = block.size(); got == block.size();) {
    got = std::fread(block.data(), 1, block.size(), file.get());
    bytes.append(block.data(), got);
    if (bytes.size() > maxBytes && !isRegular) {
      throw InputError("this is no regular file, and larger than " + std::to_string(maxBytes >> 20U) + " MiB",
                       path.string(), "save what it gives as a file, and name that");
    }
    if (bytes.size() > maxBytes) {
      throw InputError("this file is larger than " + std::to_string(maxBytes >> 20U) + " MiB, the most that it may be",
                       path.string(), "check that this is the file you mean");
    }
  }
  // A folder opens, and fails here.
  if (std::ferror(file.get()) != 0) {
    fail(errno);
  }
  return bytes;
}

}  // namespace ocelli
