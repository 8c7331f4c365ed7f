#include "oc_core/base/unfinished_output.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

namespace ocelli {
namespace {

enum class State {
  kFree,
  kBusy,      ///< a thread makes, renames or removes it, and takes no signals meanwhile
  kStanding,  ///< it lies there
  kRemoving,  ///< the program ends
};

}  // namespace

struct UnfinishedOutput::Entry {
  std::atomic<State> state = State::kBusy;
  pid_t process = 0;
  std::string path;
  Entry* next = nullptr;
};

namespace {

static_assert(std::atomic<State>::is_always_lock_free, "a signal handler takes no locks");

// A signal handler can reach nothing but globals. Entries are used again and never freed: it may be reading them.
std::atomic<UnfinishedOutput::Entry*> entries = nullptr;
std::atomic<bool> ending = false;

/// On this thread. So no handler waits for the thread that it has interrupted.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      sigaddset(&held, signal);
    }
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

[[noreturn]] void standStill() {
  while (true) {
    pause();
  }
}

bool change(UnfinishedOutput::Entry& entry, State from, State to) {
  return entry.state.compare_exchange_strong(from, to);
}

UnfinishedOutput::Entry* takeEntry() {
  for (UnfinishedOutput::Entry* entry = entries; entry != nullptr; entry = entry->next) {
    if (change(*entry, State::kFree, State::kBusy)) {
      return entry;
    }
  }
  auto* const entry = new UnfinishedOutput::Entry;
  entry->next = entries;
  while (!entries.compare_exchange_weak(entry->next, entry)) {
  }
  return entry;
}

/// What follows is for signal handlers: system calls and memory of its own alone.
void removeWhatIsIn(int folder) noexcept {
  constexpr size_t kNameOffset = offsetof(dirent64, d_name);
  alignas(dirent64) std::array<char, 2048> buffer;
  // A file system may leave out what was beside a file that was removed: until nothing more can be.
  for (bool removed = true; removed;) {
    removed = false;
    lseek(folder, 0, SEEK_SET);
    for (ssize_t count = 0; (count = getdents64(folder, buffer.data(), buffer.size())) > 0;) {
      for (ssize_t at = 0; at < count;) {
        const char* const item = buffer.data() + at;
        unsigned short length = 0;
        std::memcpy(&length, item + offsetof(dirent64, d_reclen), sizeof length);
        at += length;
        const char* const name = item + kNameOffset;
        if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0) {
          continue;
        }
        if (unlinkat(folder, name, 0) == 0) {
          removed = true;
        } else if (const int inner = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
                   inner >= 0) {
          removeWhatIsIn(inner);
          close(inner);
          removed = unlinkat(folder, name, AT_REMOVEDIR) == 0 || removed;
        }
      }
    }
  }
}

void removeOutput(const char* path) noexcept {
  if (unlink(path) == 0) {
    return;
  }
  const int folder = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder >= 0) {
    removeWhatIsIn(folder);
    close(folder);
    rmdir(path);
  }
}

}  // namespace

UnfinishedOutput::UnfinishedOutput(const std::filesystem::path& path, const std::function<void()>& create) {
  const std::string absolute = std::filesystem::absolute(path).string();
  const SignalsHeld held;
  entry_ = takeEntry();
  entry_->path = absolute;
  entry_->process = getpid();
  if (ending) {
    entry_->state = State::kFree;
    standStill();
  }
  try {
    create();
  } catch (...) {
    std::exchange(entry_, nullptr)->state = State::kFree;
    throw;
  }
  entry_->state = State::kStanding;
}

UnfinishedOutput::~UnfinishedOutput() {
  finish([] {});
}

UnfinishedOutput::UnfinishedOutput(UnfinishedOutput&& other) noexcept : entry_(std::exchange(other.entry_, nullptr)) {}

UnfinishedOutput& UnfinishedOutput::operator=(UnfinishedOutput&& other) noexcept {
  std::swap(entry_, other.entry_);
  return *this;
}

void UnfinishedOutput::finish(const std::function<void()>& end) {
  if (entry_ == nullptr) {
    end();
    return;
  }
  const SignalsHeld held;
  if (!change(*entry_, State::kStanding, State::kBusy)) {
    standStill();
  }
  Entry* const entry = std::exchange(entry_, nullptr);
  try {
    end();
  } catch (...) {
    entry->state = State::kFree;
    throw;
  }
  entry->state = State::kFree;
}

void removeUnfinishedOutputs() noexcept {
  constexpr int kMaxWaits = 2000;  // of a millisecond: what hangs in the system is left
  const int error = errno;
  ending = true;
  for (UnfinishedOutput::Entry* entry = entries; entry != nullptr; entry = entry->next) {
    for (int waits = 0; entry->state == State::kBusy && waits < kMaxWaits; ++waits) {
      poll(nullptr, 0, 1);
    }
    if (change(*entry, State::kStanding, State::kRemoving) && entry->process == getpid()) {
      removeOutput(entry->path.c_str());
    }
  }
  errno = error;
}

}  // namespace ocelli
