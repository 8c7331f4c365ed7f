#include "display_driver/emulator/test_bed_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdio>
#include <system_error>

namespace ocelli {
namespace {

constexpr const char* kMark = "ocelli-emulator.lock";
constexpr const char* kPrefix = "umockdev.";

}  // namespace

TestBedMark::TestBedMark(const std::filesystem::path& folder) : file_(folder / kMark) {
  // It is locked when it appears: others may be sweeping.
  const std::filesystem::path unlocked = folder / "ocelli-emulator.new";
  descriptor_ = open(unlocked.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ >= 0) {
    flock(descriptor_, LOCK_EX | LOCK_NB);
    std::rename(unlocked.c_str(), file_.c_str());
  }
}

TestBedMark::~TestBedMark() {
  unlink(file_.c_str());
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
}

size_t sweepTestBeds(const std::filesystem::path& where) {
  size_t removed = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(where, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix)) {
      continue;
    }
    const int mark = open((entry.path() / kMark).c_str(), O_RDWR | O_CLOEXEC);
    if (mark < 0) {
      continue;
    }
    if (flock(mark, LOCK_EX | LOCK_NB) == 0) {
      std::error_code failed;
      std::filesystem::remove_all(entry.path(), failed);
      removed += failed ? 0 : 1;
    }
    close(mark);
  }
  return removed;
}

}  // namespace ocelli
