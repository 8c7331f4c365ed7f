#include "oc_core/pack/placed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "oc_core/base/error.h"

namespace ocelli {

PlacedFile::PlacedFile(const std::filesystem::path& path, int flags)
    : path_(path), file_(::open(path.c_str(), flags, 0666)) {
  if (file_ < 0) {
    fail(errno);
  }
}

PlacedFile::~PlacedFile() {
  ::close(file_);
}

void PlacedFile::write(const void* bytes, size_t count, uint64_t at) const {
  const auto* from = static_cast<const uint8_t*>(bytes);
  while (count > 0) {
    const ssize_t done = ::pwrite(file_, from, count, static_cast<off_t>(at));
    if (done == 0 || (done < 0 && errno != EINTR)) {
      fail(done == 0 ? ENOSPC : errno);
    }
    const size_t some = done > 0 ? static_cast<size_t>(done) : 0;
    from += some;
    at += some;
    count -= some;
  }
}

void PlacedFile::read(void* bytes, size_t count, uint64_t at) const {
  auto* to = static_cast<uint8_t*>(bytes);
  while (count > 0) {
    const ssize_t done = ::pread(file_, to, count, static_cast<off_t>(at));
    if (done == 0 || (done < 0 && errno != EINTR)) {
      fail(done == 0 ? EIO : errno);
    }
    const size_t some = done > 0 ? static_cast<size_t>(done) : 0;
    to += some;
    at += some;
    count -= some;
  }
}

uint64_t PlacedFile::size() const {
  struct stat info {};
  if (::fstat(file_, &info) != 0) {
    fail(errno);
  }
  return static_cast<uint64_t>(info.st_size);
}

void PlacedFile::fail(int reason) const {
  throw WorkError("the triangles cannot be sorted on disk: " + std::generic_category().message(reason), path_.string(),
                  "free some space, or write the packed scene to another disk");
}

void renameComplete(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) {
    throw WorkError("this file cannot be renamed: " + error.message(), from.string(), "check its folder");
  }
}

}  // namespace ocelli
