#include "study/screen/experimenter_console.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <thread>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kLookMilliseconds = 100;

void writeAll(int descriptor, const std::string& text) {
  for (size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) {
      return;  // nobody reads any more
    }
    done += static_cast<size_t>(std::max<ssize_t>(count, 0));
  }
}

}  // namespace

struct ExperimenterConsole::State {
  explicit State(const ConsoleStreams& of) : streams(of), isTerminal(isatty(of.output) == 1) {
    OC_CHECK(pipe2(wake.data(), O_CLOEXEC | O_NONBLOCK) == 0, "a pipe can be made");
    thread = std::thread([this] { run(); });
  }
  ~State() {
    stopping = true;
    signal();
    thread.join();
    for (const int end : wake) {
      close(end);
    }
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void signal() const {
    const char byte = 0;
    [[maybe_unused]] const ssize_t count = ::write(wake[1], &byte, 1);
  }

  void run() {
    bool inputOpen = true;
    while (!stopping) {
      std::array<pollfd, 2> watched{{{wake[0], POLLIN, 0}, {inputOpen ? streams.input : -1, POLLIN, 0}}};
      poll(watched.data(), watched.size(), kLookMilliseconds);
      std::array<char, 256> drained{};
      while (::read(wake[0], drained.data(), drained.size()) > 0) {
      }
      if (inputOpen && (watched[1].revents & (POLLIN | POLLHUP | POLLERR | POLLNVAL)) != 0) {
        inputOpen = readSome();
      }
      show();
    }
    show();
    if (isTerminal && statusStands) {
      writeAll(streams.output, "\n");
    }
  }

  /// False at the end of the input, which leaves the session running.
  bool readSome() {
    std::array<char, 1024> bytes{};
    const ssize_t count = ::read(streams.input, bytes.data(), bytes.size());
    if (count <= 0) {
      return count < 0 && (errno == EINTR || errno == EAGAIN);
    }
    typed.append(bytes.data(), static_cast<size_t>(count));
    for (size_t end = typed.find('\n'); end != std::string::npos; end = typed.find('\n')) {
      const ConsoleLine line = parseConsoleLine(typed.substr(0, end));
      typed.erase(0, end + 1);
      const std::scoped_lock lock(mutex);
      if (const auto* mistake = std::get_if<ConsoleMistake>(&line)) {
        lines += mistake->text + "\n";
      } else if (const auto* command = std::get_if<ConsoleCommand>(&line)) {
        if (command->kind == ConsoleCommand::Kind::kHelp) {
          lines += consoleHelp();
        } else {
          commands.push_back(*command);
        }
      }
      statusStands = false;  // the terminal has gone to a new line
    }
    return true;
  }

  void show() {
    std::string text;
    std::string status;
    bool hasStep = false;
    {
      const std::scoped_lock lock(mutex);
      text = std::exchange(lines, {});
      hasStep = !step.empty();
      status = isTerminal ? step + "  " + figures : step;
    }
    std::string output;
    if (!text.empty()) {
      output += (isTerminal && statusStands ? "\r\033[K" : "") + text;
      statusStands = false;
    }
    if (status != shownStatus || (isTerminal && !statusStands && typed.empty())) {
      if (hasStep && (isTerminal || status != shownStatus)) {
        output += isTerminal ? "\r\033[K" + status : status + "\n";
        statusStands = isTerminal;
      }
      shownStatus = status;
    }
    if (!output.empty()) {
      writeAll(streams.output, output);
    }
  }

  ConsoleStreams streams;
  bool isTerminal;
  std::array<int, 2> wake{};
  std::atomic<bool> stopping{false};
  std::mutex mutex;
  // Guarded by the mutex.
  std::vector<ConsoleCommand> commands;
  std::string lines;  ///< to be printed
  std::string step;
  std::string figures;
  // Of the thread alone.
  std::string typed;
  std::string shownStatus;
  bool statusStands = false;
  std::thread thread;
};

ExperimenterConsole::ExperimenterConsole(const ConsoleStreams& streams) : state_(std::make_unique<State>(streams)) {}

ExperimenterConsole::~ExperimenterConsole() = default;

std::vector<ConsoleCommand> ExperimenterConsole::take() {
  const std::scoped_lock lock(state_->mutex);
  return std::exchange(state_->commands, {});
}

void ExperimenterConsole::setStatus(const std::string& step, const std::string& figures) {
  const std::scoped_lock lock(state_->mutex);
  state_->step = step;
  state_->figures = figures;
}

void ExperimenterConsole::print(const std::string& line) {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->lines += line + "\n";
  }
  state_->signal();
}

}  // namespace ocelli
