// Which signals reach a program that runs with emulated devices, and how often.
#include "display_driver/emulator/client_process.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace ocelli {
namespace {

/// runClient() on a terminal of its own, with a program that says "ready" and ends with the number of SIGINT it got.
class OnATerminal {
 public:
  OnATerminal() {
    process_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (process_ == 0) {
      const char* const counts =
          "n=0; trap 'n=$((n+1))' INT; echo ready; while [ $n = 0 ]; do sleep 0.02; done; sleep 0.3; exit $n";
      _exit(runClient({"sh", "-c", counts}, {}));
    }
    std::string said;
    std::array<char, 64> some{};
    for (ssize_t count = 0; said.find("ready") == std::string::npos; said.append(some.data(), count)) {
      count = read(terminal_, some.data(), some.size());
      if (count <= 0) {
        ADD_FAILURE() << "the program did not start: " << said;
        return;
      }
    }
  }
  ~OnATerminal() { close(terminal_); }

  pid_t process() const { return process_; }
  void type(char letter) const { EXPECT_EQ(write(terminal_, &letter, 1), 1); }
  int signalsOfTheProgram() const {
    int status = 0;
    EXPECT_EQ(waitpid(process_, &status, 0), process_);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  int terminal_ = -1;
  pid_t process_ = 0;
};

TEST(ClientProcess, controlCReachesTheProgramOnce) {
  const OnATerminal both;
  both.type('\x03');
  EXPECT_EQ(both.signalsOfTheProgram(), 1);
}

TEST(ClientProcess, aSignalForTheEmulatorIsPassedOn) {
  const OnATerminal both;
  kill(both.process(), SIGINT);
  EXPECT_EQ(both.signalsOfTheProgram(), 1);
}

}  // namespace
}  // namespace ocelli
