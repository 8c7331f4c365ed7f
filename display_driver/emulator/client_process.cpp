#include "display_driver/emulator/client_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::array kPassedOn = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t client = 0;

// What the terminal sends (Ctrl-C), which is the kernel's doing, the client has got from it as well.
extern "C" void passOn(int signal, siginfo_t* origin, void*) {
  if (client != 0 && origin->si_code != SI_KERNEL) {
    kill(client, signal);
  }
}

/// While it lives, the signals of kPassedOn go to the client. Those that are ignored stay so.
class SignalRelay {
 public:
  SignalRelay() {
    for (size_t i = 0; i < kPassedOn.size(); ++i) {
      sigaction(kPassedOn[i], nullptr, &old_[i]);
      if (old_[i].sa_handler != SIG_IGN) {
        struct sigaction action {};
        action.sa_sigaction = passOn;
        action.sa_flags = SA_RESTART | SA_SIGINFO;
        sigaction(kPassedOn[i], &action, nullptr);
      }
    }
  }
  ~SignalRelay() {
    for (size_t i = 0; i < kPassedOn.size(); ++i) {
      sigaction(kPassedOn[i], &old_[i], nullptr);
    }
    client = 0;
  }
  SignalRelay(const SignalRelay&) = delete;
  SignalRelay& operator=(const SignalRelay&) = delete;

 private:
  std::array<struct sigaction, kPassedOn.size()> old_{};
};

std::vector<std::string> environmentWith(const std::vector<std::pair<std::string, std::string>>& added) {
  std::vector<std::string> all;
  for (const auto& [name, value] : added) {
    all.push_back(name + "=" + value);
  }
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    const std::string_view name = text.substr(0, text.find('='));
    if (std::ranges::none_of(added, [&](const auto& one) { return one.first == name; })) {
      all.emplace_back(text);
    }
  }
  return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

int runClient(const std::vector<std::string>& command,
              const std::vector<std::pair<std::string, std::string>>& environment) {
  std::vector<std::string> words = command;
  std::vector<std::string> variables = environmentWith(environment);
  const std::vector<char*> arguments = pointersTo(words);
  const std::vector<char*> settings = pointersTo(variables);
  std::array<int, 2> failure{};  // the error of exec, or nothing
  if (pipe2(failure.data(), O_CLOEXEC) != 0) {
    throw WorkError("cannot start a program", command.front(), "close other programs");
  }
  const pid_t parent = getpid();
  const SignalRelay relay;
  const pid_t child = fork();
  if (child == 0) {
    // Other threads of the parent may hold any lock: only calls that take none.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const int signal : kPassedOn) {
      struct sigaction now {};
      sigaction(signal, nullptr, &now);
      if (now.sa_handler != SIG_IGN) {
        std::signal(signal, SIG_DFL);
      }
    }
    std::signal(SIGPIPE, SIG_DFL);
    if (getppid() == parent) {
      execvpe(arguments[0], arguments.data(), settings.data());
    }
    const int error = errno;
    [[maybe_unused]] const ssize_t written = write(failure[1], &error, sizeof(error));
    _exit(127);
  }
  client = child;
  close(failure[1]);
  int error = child < 0 ? errno : 0;
  if (child > 0 && read(failure[0], &error, sizeof(error)) != sizeof(error)) {
    error = 0;
  }
  close(failure[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (error != 0) {
    throw WorkError(std::string("cannot start a program: ") + std::strerror(error), command.front(),
                    "give its whole path, or check the PATH");
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace ocelli
