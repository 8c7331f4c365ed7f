#include "oc_core/base/scratch_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kBufferedBytes = 1 << 20;

}  // namespace

ScratchFile::ScratchFile(const std::filesystem::path& folder) : folder_(folder.empty() ? "." : folder) {
  std::string name = (folder_ / ".scratch_XXXXXX").string();
  file_ = ::mkstemp(name.data());
  if (file_ < 0) {
    fail(errno);
  }
  ::unlink(name.c_str());
}

ScratchFile::~ScratchFile() {
  if (!mapped_.empty()) {
    ::munmap(mapped_.data(), mapped_.size());
  }
  ::close(file_);
}

std::filesystem::path ScratchFile::link() const {
  return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file_);
}

void ScratchFile::fail(int reason) const {
  throw WorkError("what does not fit into memory cannot be written here: " + std::generic_category().message(reason),
                  folder_.string(), "free some space, or write to another disk");
}

void ScratchFile::append(std::span<const uint8_t> bytes) {
  OC_CHECK(mapped_.empty(), "nothing is appended to what is mapped");
  buffered_.insert(buffered_.end(), bytes.begin(), bytes.end());
  if (buffered_.size() >= kBufferedBytes) {
    flush();
  }
}

void ScratchFile::flush() {
  for (size_t done = 0; done < buffered_.size();) {
    const ssize_t some = ::pwrite(file_, buffered_.data() + done, buffered_.size() - done, static_cast<off_t>(size_));
    if (some == 0 || (some < 0 && errno != EINTR)) {
      fail(some == 0 ? ENOSPC : errno);
    }
    const size_t count = some > 0 ? static_cast<size_t>(some) : 0;
    done += count;
    size_ += count;
  }
  buffered_.clear();
}

void ScratchFile::appendZeros(uint64_t bytes) {
  OC_CHECK(mapped_.empty(), "nothing is appended to what is mapped");
  flush();
  // A file with holes would run out of space later, as a SIGBUS.
  if (const int reason = bytes > 0 ? ::posix_fallocate(file_, static_cast<off_t>(size_), static_cast<off_t>(bytes)) : 0;
      reason != 0) {
    fail(reason);
  }
  size_ += bytes;
}

std::span<uint8_t> ScratchFile::map() {
  flush();
  if (mapped_.empty() && size_ > 0) {
    void* at = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    if (at == MAP_FAILED) {
      fail(errno);
    }
    mapped_ = {static_cast<uint8_t*>(at), size_};
  }
  return mapped_;
}

void ScratchFile::release() const {
  if (!mapped_.empty()) {
    ::madvise(mapped_.data(), mapped_.size(), MADV_DONTNEED);
  }
}

}  // namespace ocelli
