#include "oc_core/base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kMaxKnown = 32;
constexpr size_t kMaxPathBytes = 1024;

/// What a signal handler may read of a mapping. `begin` is written last and cleared first.
struct KnownMapping {
  std::atomic<bool> taken = false;
  std::atomic<uintptr_t> begin = 0;
  std::atomic<size_t> size = 0;
  std::array<char, kMaxPathBytes> path{};
};

static_assert(std::atomic<uintptr_t>::is_always_lock_free, "a signal handler takes no locks");

// A signal handler can reach nothing but a global.
std::array<KnownMapping, kMaxKnown> knownMappings;

/// Where it stands from now on; kMaxKnown where there are so many already, and this one stays unknown.
size_t remember(std::span<const uint8_t> bytes, const std::string& path) {
  for (size_t slot = 0; slot < kMaxKnown; ++slot) {
    KnownMapping& known = knownMappings[slot];
    if (!known.taken.exchange(true)) {
      known.path[path.copy(known.path.data(), kMaxPathBytes - 1)] = '\0';
      known.size = bytes.size();
      known.begin = reinterpret_cast<uintptr_t>(bytes.data());
      return slot;
    }
  }
  return kMaxKnown;
}

void forget(size_t slot) {
  if (slot < kMaxKnown) {
    knownMappings[slot].begin = 0;
    knownMappings[slot].taken = false;
  }
}

/// For calls that advise of it or unmap it.
uint8_t* addressOf(const uint8_t* bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): it is not written to
  return const_cast<uint8_t*>(bytes);
}

std::span<const uint8_t> mapped(const std::filesystem::path& path) {
  const auto fail = [&](int reason) {
    throw InputError(std::string("cannot read this file (") + std::strerror(reason) + ")", path.string(),
                     "check the path and your rights");
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    fail(errno);
  }
  struct stat info {};
  int reason = ::fstat(file, &info) == 0 ? 0 : errno;
  if (reason == 0 && !S_ISREG(info.st_mode)) {
    reason = S_ISDIR(info.st_mode) ? EISDIR : EINVAL;
  }
  const size_t size = reason == 0 ? static_cast<size_t>(info.st_size) : 0;
  void* at = nullptr;
  if (size > 0) {
    at = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
    reason = at == MAP_FAILED ? errno : 0;
  }
  ::close(file);
  if (reason != 0) {
    fail(reason);
  }
  return {static_cast<const uint8_t*>(at), size};
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path) : bytes_(mapped(path)), slot_(kMaxKnown) {
  if (!bytes_.empty()) {
    ::madvise(addressOf(bytes_.data()), bytes_.size(), MADV_RANDOM);
    slot_ = remember(bytes_, path.string());
  }
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, {})), slot_(std::exchange(other.slot_, kMaxKnown)) {}

MappedFile::~MappedFile() {
  forget(slot_);
  if (!bytes_.empty()) {
    ::munmap(addressOf(bytes_.data()), bytes_.size());
  }
}

void MappedFile::willNeed(size_t begin, size_t end) const {
  const auto page = static_cast<size_t>(::sysconf(_SC_PAGESIZE));
  begin = begin / page * page;
  ::madvise(addressOf(bytes_.data()) + begin, end - begin, MADV_WILLNEED);
}

void MappedFile::release() const {
  ::madvise(addressOf(bytes_.data()), bytes_.size(), MADV_DONTNEED);
}

void MappedFile::release(size_t begin, size_t end) const {
  const auto page = static_cast<size_t>(::sysconf(_SC_PAGESIZE));
  begin = (begin + page - 1) / page * page;
  end = end == bytes_.size() ? end : end / page * page;
  if (begin < end) {
    ::madvise(addressOf(bytes_.data()) + begin, end - begin, MADV_DONTNEED);
  }
}

const char* mappedFileAt(const void* address) noexcept {
  const auto at = reinterpret_cast<uintptr_t>(address);
  for (const KnownMapping& known : knownMappings) {
    const uintptr_t begin = known.begin;
    if (begin != 0 && at >= begin && at - begin < known.size) {
      return known.path.data();
    }
  }
  return nullptr;
}

}  // namespace ocelli
