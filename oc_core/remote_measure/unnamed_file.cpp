#include "oc_core/remote_measure/unnamed_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

[[noreturn]] void failUnnamed(const std::filesystem::path& folder) {
  throw WorkError(std::string("cannot keep frames in a file (") + std::strerror(errno) + ")", folder.string(),
                  "free some space there, or set TMPDIR to another folder");
}

}  // namespace

UnnamedFile::UnnamedFile() : UnnamedFile(std::filesystem::temp_directory_path()) {}

UnnamedFile::UnnamedFile(const std::filesystem::path& folder) : folder_(folder) {
  file_ = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file_ < 0) {
    // A file system without O_TMPFILE.
    std::string name = (folder / "ocelli-XXXXXX").string();
    file_ = mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) {
      failUnnamed(folder_);
    }
    unlink(name.c_str());
  }
}

UnnamedFile::~UnnamedFile() {
  if (!mapped_.empty()) {
    munmap(const_cast<std::byte*>(mapped_.data()), mapped_.size());
  }
  close(file_);
}

void UnnamedFile::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      failUnnamed(folder_);
    }
    bytes = bytes.subspan(static_cast<size_t>(written));
  }
}

void UnnamedFile::resize(uint64_t bytes) {
  if (ftruncate(file_, static_cast<off_t>(bytes)) != 0) {
    failUnnamed(folder_);
  }
}

void UnnamedFile::writeAt(uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      failUnnamed(folder_);
    }
    bytes = bytes.subspan(static_cast<size_t>(written));
    offset += static_cast<uint64_t>(written);
  }
}

std::string UnnamedFile::path() const {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file_);
}

uint64_t UnnamedFile::size() const {
  struct stat status {};
  if (fstat(file_, &status) != 0) {
    failUnnamed(folder_);
  }
  return static_cast<uint64_t>(status.st_size);
}

std::span<const std::byte> UnnamedFile::map() {
  const uint64_t bytes = size();
  if (mapped_.empty() && bytes > 0) {
    void* const address = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file_, 0);
    if (address == MAP_FAILED) {
      failUnnamed(folder_);
    }
    mapped_ = {static_cast<const std::byte*>(address), bytes};
  }
  return mapped_;
}

}  // namespace ocelli
