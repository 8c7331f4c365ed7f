#include "study/store/database_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "study/session/utc_time.h"

namespace ocelli {
namespace {

/// The first line of the file.
std::string firstLine(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size() - 1, 0);
  const std::string holder(text.data(), size > 0 ? static_cast<size_t>(size) : 0);
  const std::string line = holder.substr(0, holder.find('\n'));
  return line.empty() ? "a process that did not say which" : line;
}

/// Whether the name still stands for the file that is open: its last holder removes it.
bool isStillNamed(int descriptor, const std::filesystem::path& file) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

}  // namespace

std::filesystem::path withoutLinks(const std::filesystem::path& database) {
  constexpr int kMaxLinks = 40;  // as Linux has it
  std::error_code error;
  std::filesystem::path file = std::filesystem::absolute(database);
  // A link may lead to a file that is yet to be made.
  for (int i = 0; i < kMaxLinks && std::filesystem::is_symlink(file, error); ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(file, error);
    if (error) {
      break;
    }
    file = file.parent_path() / next;
  }
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
  return error ? file : canonical;
}

std::filesystem::path DatabaseLock::fileOf(const std::filesystem::path& database, DatabaseUse use) {
  std::filesystem::path file = withoutLinks(database);
  file += use == DatabaseUse::kSessions ? ".lock" : ".export.lock";
  return file;
}

std::optional<std::string> DatabaseLock::holderOf(const std::filesystem::path& database) {
  const int descriptor = open(fileOf(database).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return std::nullopt;
  }
  std::optional<std::string> holder;
  if (flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    holder = firstLine(descriptor);
  }
  close(descriptor);
  return holder;
}

DatabaseLock::DatabaseLock(const std::filesystem::path& database, DatabaseUse use) : file_(fileOf(database, use)) {
  while (true) {
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) {
      throw WorkError(fmt::format("cannot make the lock of this database ({})", std::strerror(errno)), file_.string(),
                      "check that the folder exists and may be written to");
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      const std::string holder = firstLine(descriptor_);
      close(std::exchange(descriptor_, -1));
      if (reason != EWOULDBLOCK) {
        throw WorkError(fmt::format("cannot lock this database ({})", std::strerror(reason)), file_.string(),
                        "a folder on a local disk");
      }
      if (use == DatabaseUse::kExport) {
        throw WorkError(fmt::format("an export or a withdrawal of this database is under way: {}", holder),
                        database.string(), "wait for its end");
      }
      throw WorkError(fmt::format("another program uses this database: {}", holder), database.string(),
                      "close that program; two stations use two databases, which `ocelli study merge` joins");
    }
    if (isStillNamed(descriptor_, file_)) {
      break;
    }
    close(std::exchange(descriptor_, -1));
  }
  const std::string holder = fmt::format("process {} on {}, since {}\n", getpid(), computerName(), utcNow());
  // The text only helps people; the lock holds without it.
  if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, holder.data(), holder.size(), 0) < 0) {
    errno = 0;
  }
}

DatabaseLock::DatabaseLock(DatabaseLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

DatabaseLock::~DatabaseLock() {
  if (descriptor_ >= 0) {
    unlink(file_.c_str());
    close(descriptor_);
  }
}

}  // namespace ocelli
