// Ctrl-C and SIGTERM at any moment: nothing half written stays, and the exit code says so.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

namespace fs = std::filesystem;

class Signals : public testing::TestWithParam<const char*> {};

pid_t start(const std::string& command, const fs::path& folder) {
  const pid_t child = fork();
  if (child == 0) {
    // As from a terminal, whatever this test was started by.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    const std::string line =
        fmt::format("cd '{}' && exec '{}' {} >/dev/null 2>&1 </dev/null", folder.string(), OCELLI_PROGRAM, command);
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  return child;
}

/// Until something unfinished appears in the folder, or the program has ended.
void awaitUnfinished(int watch, pid_t child) {
  alignas(inotify_event) std::array<char, 4096> events;
  while (waitid(P_PID, static_cast<id_t>(child), nullptr, WEXITED | WNOHANG | WNOWAIT) == 0) {
    pollfd waits{watch, POLLIN, 0};
    siginfo_t ended{};
    waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid == child) {
      return;
    }
    if (poll(&waits, 1, 5) <= 0) {
      continue;
    }
    const ssize_t count = read(watch, events.data(), events.size());
    for (ssize_t at = 0; at < count;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(events.data() + at);
      if (event->len > 0 && std::string(event->name).find(".partial") != std::string::npos) {
        return;
      }
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
  }
}

TEST_P(Signals, leaveNothingHalfWritten) {
  std::mt19937 random(1);
  const TemporaryFolder inputs;
  ASSERT_EQ(runShell("cd '" + inputs.path().string() +
                     "' && \"$OCELLI\" slice builtin:teapot --profile test -o a.svol -q"
                     " && \"$OCELLI\" ocri build builtin:teapot --size 300x200 -o a.exr -q")
                .exitCode,
            0);
  int ended = 0;
  for (int round = 0; round < 8; ++round) {
    const TemporaryFolder folder;
    for (const char* input : {"a.svol", "a.exr"}) {
      fs::create_symlink(inputs / input, folder / input);
    }
    const int watch = inotify_init1(IN_CLOEXEC);
    inotify_add_watch(watch, folder.path().c_str(), IN_CREATE | IN_MOVED_TO);
    const pid_t child = start(GetParam(), folder.path());
    // The first unfinished file may be the one that tries whether the folder is writable, or the output itself.
    for (int i = 0; i <= round % 2; ++i) {
      awaitUnfinished(watch, child);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 4 == 0 ? random() % 20000 : 0));
    const int signal = round % 4 < 2 ? SIGINT : SIGTERM;
    kill(child, signal);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    close(watch);
    const bool killed = WIFSIGNALED(status) && WTERMSIG(status) == signal;
    // 1: "interrupted: nothing is written". 0: it was done before the signal came.
    EXPECT_TRUE(killed || (WIFEXITED(status) && WEXITSTATUS(status) <= 1)) << status;
    ended += killed || WEXITSTATUS(status) == 1 ? 1 : 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path())) {
      EXPECT_THAT(entry.path().filename().string(), testing::Not(testing::HasSubstr(".partial")));
    }
  }
  EXPECT_GT(ended, 0) << "no signal came in time: the work is too short for this test";
}

INSTANTIATE_TEST_SUITE_P(
    Commands, Signals,
    testing::Values("scene export builtin:statues,triangles=400000 -o x.ply",
                    "render builtin:statues --size 1200x800 -o x.exr", "render builtin:statues -o x.png",
                    "ocri build builtin:statues --camera di --size 1200x800 -o x.exr", "ocri mesh a.exr -o x.ply",
                    "slice builtin:statues -o x.svol", "observe a.svol -o x.png", "observe a.svol -o x.exr",
                    "observe a.svol --size 90x60 --turntable 50 -o x", "volume export a.svol -o x.vti --cells 200",
                    "volume export a.svol -o x.nrrd", "volume export a.svol -o x", "volume export a.svol -o x.png",
                    "volume join $(yes a.svol | head -n 500) -o x.svol",
                    "device selftest --profile test --pattern dark axis wedges -o .",
                    "camera info builtin:town --camera portal -o x.json",
                    "camera show builtin:town --camera portal -o x.svg",
                    "evaluate builtin:fence --cameras di --size 90x60 --interior 0 --directions 0 --runs 1 --csv x.csv "
                    "--json x.json",
                    "present a.svol --device file:x.svol --timeline x.csv --seconds 0.5",
                    "present a.svol --device sim --watch x --watch-size 60x60 --seconds 0.5"));

}  // namespace
}  // namespace ocelli::test
