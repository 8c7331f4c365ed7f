#include "display_driver/serial/pty_display.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "display_driver/serial/serial_display.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// A pseudo-terminal with both ends open: ours, and that of programs, so that it lives while none has it open.
class Terminal {
 public:
  explicit Terminal(const std::filesystem::path& link) {
    own_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    std::array<char, 128> name{};
    if (own_ < 0 || grantpt(own_) != 0 || unlockpt(own_) != 0 || ptsname_r(own_, name.data(), name.size()) != 0) {
      fail(link, errno);
    }
    other_ = open(name.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    termios settings{};
    if (other_ < 0 || tcgetattr(other_, &settings) != 0) {
      fail(link, errno);
    }
    cfmakeraw(&settings);
    tcsetattr(other_, TCSANOW, &settings);
    std::error_code error;
    std::filesystem::remove(link, error);
    std::filesystem::create_symlink(name.data(), link, error);
    if (error) {
      fail(link, error.value());
    }
  }
  ~Terminal() { closeBoth(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int descriptor() const { return own_; }

 private:
  [[noreturn]] void fail(const std::filesystem::path& link, int error) {
    closeBoth();
    throw WorkError("cannot make a pseudo-terminal (" + std::generic_category().message(error) + ")", link.string(),
                    "check that /dev/pts is there and this path is writable");
  }
  void closeBoth() const {
    for (const int descriptor : {own_, other_}) {
      if (descriptor >= 0) {
        close(descriptor);
      }
    }
  }

  int own_ = -1;
  int other_ = -1;
};

}  // namespace

struct PtyDisplay::State {
  State(EmulatedDeviceOptions options, std::filesystem::path path)
      : link(std::move(path)), device(std::move(options)), display(device), terminal(std::in_place, link) {}

  DeviceMicroseconds now() const {
    return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start).count();
  }

  /// Damages or drops some of the bytes.
  std::vector<uint8_t> throughNoise(std::span<const uint8_t> bytes) {
    std::vector<uint8_t> noisy;
    for (const uint8_t byte : bytes) {
      const uint32_t oneIn = noise;
      if (oneIn == 0 || random.below(oneIn) != 0) {
        noisy.push_back(byte);
      } else if (random.below(2) == 0) {
        noisy.push_back(static_cast<uint8_t>(byte ^ (1 << random.below(8))));
      }
    }
    return noisy;
  }

  void readTerminal() {
    std::array<uint8_t, 4096> bytes;
    const ssize_t came = read(terminal->descriptor(), bytes.data(), bytes.size());
    if (came > 0) {
      display.read(throughNoise(std::span(bytes).first(static_cast<size_t>(came))), now());
    }
  }

  void writeTerminal() {
    std::vector<uint8_t>& line = display.line();
    if (line.empty()) {
      return;
    }
    if (noise != 0) {
      line = throughNoise(line);
    }
    const ssize_t went = line.empty() ? 0 : write(terminal->descriptor(), line.data(), line.size());
    if (went > 0) {
      line.erase(line.begin(), line.begin() + went);
    }
  }

  /// Unplugged: the terminal goes, and with it the connection. Plugged in again: another one comes.
  void followPlug() {
    if (device.pluggedIn() == terminal.has_value()) {
      return;
    }
    if (terminal) {
      terminal.reset();
      std::error_code ignored;
      std::filesystem::remove(link, ignored);
    } else {
      display.disconnect();
      try {
        terminal.emplace(link);
      } catch (const Error&) {
        // It is tried again.
      }
    }
  }

  void run() {
    constexpr int kPollMilliseconds = 1;
    while (!ending) {
      pollfd watched{-1, POLLIN, 0};
      {
        const std::lock_guard lock(mutex);
        watched.fd = terminal ? terminal->descriptor() : -1;
      }
      poll(&watched, 1, kPollMilliseconds);
      const std::lock_guard lock(mutex);
      if (terminal) {
        readTerminal();
      }
      display.advance(now());
      followPlug();
      if (terminal) {
        writeTerminal();
      }
    }
  }

  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::filesystem::path link;
  std::atomic<bool> ending = false;
  std::atomic<uint32_t> noise = 0;
  std::mutex mutex;  ///< over what follows
  EmulatedDevice device;
  SerialDisplay display;
  std::optional<Terminal> terminal;
  Random random{1};
  std::thread thread;
};

PtyDisplay::PtyDisplay(EmulatedDeviceOptions options, std::filesystem::path link)
    : state_(std::make_unique<State>(std::move(options), std::move(link))) {
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

PtyDisplay::~PtyDisplay() {
  state_->ending = true;
  state_->thread.join();
  std::error_code ignored;
  std::filesystem::remove(state_->link, ignored);
}

const std::filesystem::path& PtyDisplay::path() const {
  return state_->link;
}

void PtyDisplay::setNoise(uint32_t oneIn) {
  state_->noise = oneIn;
}

uint64_t PtyDisplay::damagedPackets() const {
  const std::lock_guard lock(state_->mutex);
  return state_->display.damagedPackets();
}

void PtyDisplay::withDevice(const std::function<void(EmulatedDevice&, DeviceMicroseconds)>& use) {
  const std::lock_guard lock(state_->mutex);
  use(state_->device, state_->now());
}

}  // namespace ocelli
