#include "oc_core/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kMaxMessageBytes = 4096;
constexpr int kTickMilliseconds = 50;

[[noreturn]] void fail(const std::string& what, int reason, const std::string& where) {
  throw WorkError(what + " (" + std::strerror(reason) + ")", where, "close other programs, and try again");
}

class Descriptor {
 public:
  Descriptor() = default;
  /// Above those that a child has other uses for.
  explicit Descriptor(int number) : number_(number < 0 ? number : fcntl(number, F_DUPFD_CLOEXEC, 10)) {
    if (number >= 0) {
      close(number);
    }
  }
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return number_; }
  bool valid() const { return number_ >= 0; }
  void reset() {
    if (number_ >= 0) {
      close(number_);
      number_ = -1;
    }
  }

 private:
  int number_ = -1;
};

/// What posix_spawn() is told about descriptors, signals and the process group.
class SpawnSettings {
 public:
  SpawnSettings(int messages, int result) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, messages, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, messages, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, result, kChildResultDescriptor);
    posix_spawn_file_actions_addclosefrom_np(&actions_, kChildResultDescriptor + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// A child that is killed, with what it has started, and reaped when it goes out of scope.
class RunningChild {
 public:
  RunningChild(const ChildCommand& command, const SpawnSettings& settings) {
    std::vector<std::string> texts{command.program.string()};
    texts.insert(texts.end(), command.arguments.begin(), command.arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) {
      pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    const int error =
        posix_spawn(&id_, command.program.c_str(), settings.actions(), settings.attributes(), pointers.data(), environ);
    if (error != 0) {
      id_ = -1;
      fail("cannot start this program", error, command.program.string());
    }
  }
  ~RunningChild() {
    if (id_ > 0) {
      kill(-id_, SIGKILL);
      while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }
  RunningChild(const RunningChild&) = delete;
  RunningChild& operator=(const RunningChild&) = delete;

  /// Its status, as waitpid() gives it, once it has ended.
  std::optional<int> ended() {
    int status = 0;
    const pid_t got = waitpid(id_, &status, WNOHANG);
    if (got == 0 || (got < 0 && errno == EINTR)) {
      return std::nullopt;
    }
    if (got < 0) {
      const int reason = errno;
      id_ = -1;
      fail("cannot wait for a program that was started", reason, "");
    }
    // What it has started itself must not stay.
    kill(-id_, SIGKILL);
    id_ = -1;
    return status;
  }

 private:
  pid_t id_ = -1;
};

/// The end of what comes through a pipe.
class Messages {
 public:
  explicit Messages(Descriptor& source) : source_(source) { fcntl(source_.get(), F_SETFL, O_NONBLOCK); }

  /// Waits for more, not at all for 0 milliseconds. False where nothing came.
  bool read(int milliseconds) {
    pollfd waited{source_.get(), POLLIN, 0};  // a closed one is passed over, and only the time passes
    if (poll(&waited, 1, milliseconds) <= 0) {
      return false;
    }
    std::array<char, kMaxMessageBytes> block;
    const ssize_t got = ::read(source_.get(), block.data(), block.size());
    if (got > 0) {
      text.append(block.data(), static_cast<size_t>(got));
      if (text.size() > kMaxMessageBytes) {
        text.erase(0, text.size() - kMaxMessageBytes);
      }
    } else if (got == 0) {
      source_.reset();
    }
    return got > 0;
  }

  bool open() const { return source_.valid(); }

  std::string text;

 private:
  Descriptor& source_;
};

}  // namespace

ChildBytes::ChildBytes(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) {
    fail("cannot read the result of a program", errno, "");
  }
  const auto size = static_cast<size_t>(status.st_size);
  if (size == 0) {
    return;
  }
  void* address = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (address == MAP_FAILED) {
    fail("cannot read the result of a program", errno, "");
  }
  mapping_ =
      std::shared_ptr<const void>(address, [size](const void* mapped) { munmap(const_cast<void*>(mapped), size); });
  bytes_ = {static_cast<const std::byte*>(address), size};
}

ChildEnd runChild(const ChildCommand& command, const std::function<void()>& tick) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(command.seconds));
  const Descriptor result(memfd_create("ocelli-result", MFD_CLOEXEC));
  std::array<int, 2> ends{-1, -1};
  if (!result.valid() || pipe2(ends.data(), O_CLOEXEC) != 0) {
    fail("cannot make what a program is to write to", errno, command.program.string());
  }
  Descriptor source(ends[0]);
  Descriptor sink(ends[1]);
  Messages messages(source);
  RunningChild child(command, SpawnSettings(sink.get(), result.get()));
  sink.reset();

  ChildEnd end;
  std::optional<int> status;
  while (!(status = child.ended())) {
    if (Clock::now() > deadline) {
      end.how = ChildEnd::How::kOutOfTime;
      end.messages = std::move(messages.text);
      return end;
    }
    // The pipe is closed a moment before the child can be waited for.
    messages.read(messages.open() ? kTickMilliseconds : 1);
    tick();
  }
  while (messages.open() && messages.read(0)) {
  }
  end.how = WIFSIGNALED(*status) ? ChildEnd::How::kKilledBySignal : ChildEnd::How::kExited;
  end.code = WIFSIGNALED(*status) ? WTERMSIG(*status) : WEXITSTATUS(*status);
  end.messages = std::move(messages.text);
  end.result = ChildBytes(result.get());
  return end;
}

void endWithParent(int parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // It may have ended before.
  if (getppid() != parent) {
    _exit(1);
  }
}

}  // namespace ocelli
