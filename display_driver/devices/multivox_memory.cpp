#include "display_driver/devices/multivox_memory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr size_t kPartBytes = 65536;

/// What follows the two pages.
struct Footer {
  uint8_t page = 0;
  uint8_t bitsPerChannel = 0;
  uint16_t flags = 0;
  uint16_t revolutionsPerMinute = 0;
  uint16_t microsecondsPerFrame = 0;
};
static_assert(sizeof(Footer) == 8);

std::string errorText(int error) {
  return std::generic_category().message(error);
}

}  // namespace

size_t multivoxBytes(const VoxelGrid& grid) {
  return 2 * grid.cells() + sizeof(Footer);
}

MultivoxMemory::MultivoxMemory(std::string object, const VoxelGrid& grid) : object_(std::move(object)), grid_(grid) {}

MultivoxMemory::~MultivoxMemory() {
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
}

MultivoxMemory::Found MultivoxMemory::lose(std::string problem) {
  if (descriptor_ >= 0) {
    close(descriptor_);
    descriptor_ = -1;
  }
  problem_ = std::move(problem);
  return Found::kNothing;
}

void MultivoxMemory::rest() {
  const std::optional<MultivoxStatus> now = status();
  const std::chrono::microseconds frames = now ? 2 * now->frameTime : std::chrono::microseconds(0);
  rested_ = Clock::now() + std::max<std::chrono::microseconds>(kMinRest, frames);
}

MultivoxMemory::Found MultivoxMemory::look() {
  const int found = shm_open(object_.c_str(), O_RDWR | O_CLOEXEC, 0);
  if (found < 0) {
    if (errno == ENOENT) {
      return lose(
          fmt::format("there is no shared memory {} yet; on this machine start the display's driver, as in sudo "
                      "./vortex, or its simulator, ./virtex, of the multivox project",
                      object_));
    }
    return lose(fmt::format("cannot open the shared memory {}: {}", object_, errorText(errno)));
  }
  struct stat state {};
  if (fstat(found, &state) != 0) {
    const int error = errno;
    close(found);
    return lose(fmt::format("cannot look at the shared memory {}: {}", object_, errorText(error)));
  }
  if (static_cast<size_t>(state.st_size) != multivoxBytes(grid_)) {
    close(found);
    return lose(
        fmt::format("the shared memory {} has {} bytes instead of {}; it needs a display of {} x {} x {} cells of "
                    "one byte, and a driver that keeps revolutions per minute and microseconds per frame",
                    object_, state.st_size, multivoxBytes(grid_), grid_.x, grid_.y, grid_.z));
  }
  if (descriptor_ >= 0 && device_ == state.st_dev && inode_ == state.st_ino) {
    close(found);
    return Found::kSame;
  }
  lose({});
  descriptor_ = found;
  device_ = state.st_dev;
  inode_ = state.st_ino;
  shown_.reset();
  rest();  // a writer before us may have changed pages just now
  return Found::kNew;
}

bool MultivoxMemory::sizeIsRight() {
  struct stat state {};
  if (descriptor_ < 0 || fstat(descriptor_, &state) != 0 ||
      static_cast<size_t>(state.st_size) != multivoxBytes(grid_)) {
    lose(fmt::format("the shared memory {} has changed its size", object_));
    return false;
  }
  return true;
}

std::optional<MultivoxStatus> MultivoxMemory::status() const {
  Footer footer;
  std::array<uint8_t, sizeof(Footer)> bytes{};
  if (descriptor_ < 0 || pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(2 * grid_.cells())) !=
                             static_cast<ssize_t>(bytes.size())) {
    return std::nullopt;
  }
  std::memcpy(&footer, bytes.data(), bytes.size());
  return MultivoxStatus{.shownPage = footer.page != 0 ? 1 : 0,
                        .bitsPerChannel = footer.bitsPerChannel,
                        .revolutionsPerMinute = footer.revolutionsPerMinute,
                        .frameTime = std::chrono::microseconds(footer.microsecondsPerFrame)};
}

bool MultivoxMemory::writeAt(size_t offset, std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    if (!sizeIsRight()) {
      return false;
    }
    const ssize_t count =
        pwrite(descriptor_, bytes.data(), std::min(bytes.size(), kPartBytes), static_cast<off_t>(offset));
    if (count < 0 && errno != EINTR) {
      lose(fmt::format("cannot write to the shared memory {}: {}", object_, errorText(errno)));
      return false;
    }
    const size_t done = count > 0 ? static_cast<size_t>(count) : 0;
    bytesSent_ += done;
    offset += done;
    bytes = bytes.subspan(done);
  }
  return true;
}

bool MultivoxMemory::write(std::span<const uint8_t> cells) {
  OC_CHECK(cells.size() == grid_.cells(), "cells of another grid");
  OC_CHECK(Clock::now() >= rested_, "the page is still being read");
  const std::optional<MultivoxStatus> now = status();
  if (!now) {
    lose(fmt::format("the shared memory {} can no longer be read", object_));
    return false;
  }
  problem_ = shown_ && *shown_ != now->shownPage
                 ? fmt::format("another program shows pages of the shared memory {} too; end it", object_)
                 : std::string();
  shown_ = now->shownPage;
  written_ = 1 - now->shownPage;
  return writeAt(static_cast<size_t>(written_) * grid_.cells(), cells);
}

bool MultivoxMemory::show() {
  // What was written must be seen before the number of the page, by readers on other cores too. (GCC does not compile
  // std::atomic_thread_fence() for ThreadSanitizer.)
  __sync_synchronize();
  const auto page = static_cast<uint8_t>(written_);
  if (!writeAt(2 * grid_.cells(), {&page, 1})) {
    return false;
  }
  shown_ = written_;
  rest();
  return true;
}

}  // namespace ocelli
