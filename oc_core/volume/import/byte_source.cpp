#include "oc_core/volume/import/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

[[noreturn]] void failTooShort(const std::string& name) {
  throw InputError("the file ends too early", name, "copy or export it again");
}

[[noreturn]] void failSystem(const std::string& name, int reason) {
  throw InputError(std::string("cannot read this file (") + std::strerror(reason) + ")", name,
                   "check the path and your rights");
}

}  // namespace

FileSource::FileSource(const std::filesystem::path& path, ReadingBudget* budget) : ByteSource(path.string()) {
  // O_NONBLOCK: a pipe without a writer would hold it up.
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0) {
    failSystem(name(), errno);
  }
  struct stat info {};
  const int reason = ::fstat(file_, &info) != 0 ? errno
                     : S_ISDIR(info.st_mode)    ? EISDIR
                     : S_ISREG(info.st_mode)    ? 0
                                                : EINVAL;
  if (reason != 0) {
    ::close(std::exchange(file_, -1));
    failSystem(name(), reason);
  }
  size_ = static_cast<uint64_t>(info.st_size);
  constexpr uint64_t kBlockBytes = 512;  // of st_blocks, whatever those of the disk are
  storedBytes_ = std::min(size_, kBlockBytes * static_cast<uint64_t>(info.st_blocks));
  if (budget != nullptr) {
    budget->addFile(size_);
  }
}

FileSource::~FileSource() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

void FileSource::read(uint64_t offset, std::span<std::byte> into) const {
  if (offset > size_ || into.size() > size_ - offset) {
    failTooShort(name());
  }
  while (!into.empty()) {
    const ssize_t got = ::pread(file_, into.data(), into.size(), static_cast<off_t>(offset));
    if (got < 0 && errno != EINTR) {
      failSystem(name(), errno);
    }
    if (got == 0) {
      failTooShort(name());
    }
    const size_t count = got > 0 ? static_cast<size_t>(got) : 0;
    into = into.subspan(count);
    offset += count;
  }
}

uint64_t FileSource::skipHole(uint64_t offset) const {
  const off_t data = ::lseek(file_, static_cast<off_t>(offset), SEEK_DATA);
  if (data < 0) {
    // ENXIO: nothing but a hole up to the end. Other reasons: this file system does not tell.
    return errno == ENXIO ? size_ : offset;
  }
  return static_cast<uint64_t>(data);
}

void MemorySource::read(uint64_t offset, std::span<std::byte> into) const {
  if (offset > bytes_.size() || into.size() > bytes_.size() - offset) {
    failTooShort(name());
  }
  if (!into.empty()) {
    std::memcpy(into.data(), bytes_.data() + offset, into.size());
  }
}

}  // namespace ocelli
