#include "display_driver/emulator/test_bed_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <system_error>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr const char* kPrefix = "ocelli-usb.";

struct Shared {
  std::mutex mutex;
  size_t users = 0;
  std::filesystem::path path;  ///< empty until there has been one
  int lock = -1;
};

Shared& shared() {
  static Shared shared;
  return shared;
}

/// The descriptor of the locked folder; -1 where it is no longer there: somebody was sweeping.
int locked(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat opened {};
  struct stat there {};
  if (descriptor < 0) {
    return -1;
  }
  if (flock(descriptor, LOCK_EX) == 0 && fstat(descriptor, &opened) == 0 && lstat(folder.c_str(), &there) == 0 &&
      opened.st_ino == there.st_ino && opened.st_dev == there.st_dev) {
    return descriptor;
  }
  close(descriptor);
  return -1;
}

/// Makes and locks it.
int make(std::filesystem::path& path) {
  for (int attempt = 0; attempt < 10; ++attempt) {
    std::string name = (std::filesystem::temp_directory_path() / (std::string(kPrefix) + "XXXXXX")).string();
    const bool made = path.empty() ? mkdtemp(name.data()) != nullptr : mkdir(path.c_str(), 0700) == 0;
    if (!made) {
      break;
    }
    const std::filesystem::path folder = path.empty() ? std::filesystem::path(name) : path;
    if (const int lock = locked(folder); lock >= 0) {
      path = folder;
      return lock;
    }
  }
  throw WorkError(std::string("cannot make a folder for emulated devices: ") + std::strerror(errno),
                  std::filesystem::temp_directory_path().string(), "set TMPDIR to another folder");
}

}  // namespace

TestBedFolder::TestBedFolder() {
  Shared& all = shared();
  const std::scoped_lock lock(all.mutex);
  if (all.users == 0) {
    all.lock = make(all.path);
  }
  ++all.users;
}

TestBedFolder::~TestBedFolder() {
  Shared& all = shared();
  const std::scoped_lock lock(all.mutex);
  if (--all.users == 0) {
    std::error_code ignored;
    std::filesystem::remove_all(all.path, ignored);
    close(all.lock);
  }
}

const std::filesystem::path& TestBedFolder::path() const {
  return shared().path;
}

size_t sweepTestBeds(const std::filesystem::path& where) {
  size_t removed = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(where, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix)) {
      continue;
    }
    const int folder = open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) {
      continue;
    }
    if (flock(folder, LOCK_EX | LOCK_NB) == 0) {
      std::error_code failed;
      std::filesystem::remove_all(entry.path(), failed);
      removed += failed ? 0 : 1;
    }
    close(folder);
  }
  return removed;
}

}  // namespace ocelli
