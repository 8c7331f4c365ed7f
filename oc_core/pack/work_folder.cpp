#include "oc_core/pack/work_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failToMake(const fs::path& path, int reason) {
  throw WorkError("this cannot be made: " + std::generic_category().message(reason), path.string(),
                  "check that its folder exists, is writable and has space, or write somewhere else");
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& output, const std::string& sourceKey) : folder_(output) {
  folder_ += ".work";
  lockFile_ = folder_ / "lock";
  takeLock(output);
  try {
    prepare(output, sourceKey);
  } catch (...) {
    if (isNew_) {
      remove();
    }
    ::close(lock_);
    throw;
  }
}

WorkFolder::~WorkFolder() {
  ::close(lock_);
}

fs::path WorkFolder::part(uint32_t index) const {
  return folder_ / fmt::format("part_{}", index);
}

void WorkFolder::takeLock(const fs::path& output) {
  while (true) {
    isNew_ = ::mkdir(folder_.c_str(), 0777) == 0;
    if (!isNew_ && errno != EEXIST) {
      failToMake(folder_, errno);
    }
    lock_ = ::open(lockFile_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0 && errno == ENOENT && !fs::is_symlink(folder_)) {
      continue;  // the job that had it removed the folder just now
    }
    if (lock_ < 0) {
      failToMake(lockFile_, errno);
    }
    // File systems without locks give other errors: there nobody can be told.
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(lock_);
      throw WorkError("another job is writing this packed scene", output.string(),
                      "wait until it has ended, or write to another file");
    }
    // Whether this is still the file of that name, and not one that the job that had it has removed.
    struct stat opened {};
    struct stat named {};
    if (::fstat(lock_, &opened) == 0 && ::stat(lockFile_.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
        opened.st_ino == named.st_ino) {
      return;
    }
    ::close(lock_);
  }
}

void WorkFolder::prepare(const fs::path& output, const std::string& sourceKey) const {
  const fs::path key = folder_ / "source";
  std::error_code none;
  // A job that was killed at once may not have come to its key. Only what such a job has made is removed.
  const bool isOurs = fs::is_regular_file(key, none) ||
                      std::all_of(fs::directory_iterator(folder_), fs::directory_iterator(), [](const auto& entry) {
                        return entry.path().filename() == "lock" || entry.path().filename() == "source.partial";
                      });
  if (!isOurs) {
    fs::remove(lockFile_, none);
    throw WorkError("there is something where this job keeps what it has made", folder_.string(),
                    "move it away, or write the packed scene somewhere else");
  }
  checkWritable(output);
  if (sourceKey.empty() || !fs::exists(key, none) || readFile(key) != sourceKey) {
    removeContents();
    writeFile(key, sourceKey);
  }
}

void WorkFolder::removeContents() const {
  std::error_code none;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder_, none)) {
    if (entry.path() != lockFile_) {
      paths.push_back(entry.path());
    }
  }
  for (const fs::path& path : paths) {
    fs::remove_all(path, none);
  }
}

void WorkFolder::remove() const {
  removeContents();
  // From here on another job may make a lock of its own; then the folder stays.
  std::error_code none;
  fs::remove(lockFile_, none);
  fs::remove(folder_, none);
}

}  // namespace ocelli
