#include "oc_core/base/child_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;
using How = ChildEnd::How;

ChildEnd runShell(
    const std::string& script, double seconds = 60, const std::function<void()>& tick = [] {}) {
  return runChild({"/bin/sh", {"-c", script}, seconds}, tick);
}

std::string textOf(const ChildBytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.bytes().data()), bytes.bytes().size()};
}

/// What has ended but was not waited for (a zombie) is not.
bool isAlive(int process) {
  std::string stat;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/stat"), stat);
  const size_t end = stat.rfind(')');
  return end != std::string::npos && stat.at(end + 2) != 'Z';
}

bool endsSoon(int process) {
  for (int i = 0; i < 200 && isAlive(process); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return !isAlive(process);
}

/// The number that a script wrote into a file; 0 while there is none.
int numberIn(const std::filesystem::path& file) {
  int number = 0;
  std::ifstream(file) >> number;
  return number;
}

TEST(RunChild, GivesExitCodeMessagesAndResult) {
  const ChildEnd end = runShell("echo out; echo err >&2; printf result >&3; exit 7");
  EXPECT_EQ(end.how, How::kExited);
  EXPECT_EQ(end.code, 7);
  EXPECT_EQ(end.messages, "out\nerr\n");
  EXPECT_EQ(textOf(end.result), "result");
}

TEST(RunChild, GivesResultsThatFillNoPipe) {
  const ChildEnd end = runShell("head -c 3000000 /dev/zero >&3");
  EXPECT_EQ(end.result.bytes().size(), 3'000'000u);
  EXPECT_EQ(runShell("true").result.bytes().size(), 0u);
}

TEST(RunChild, KeepsTheEndOfManyMessages) {
  const ChildEnd end = runShell("i=0; while [ $i -lt 5000 ]; do echo line $i; i=$((i + 1)); done");
  EXPECT_LE(end.messages.size(), 4096u);
  EXPECT_TRUE(end.messages.ends_with("line 4999\n"));
}

TEST(RunChild, TellsTheSignalOfACrash) {
  const ChildEnd end = runShell("echo last words; kill -SEGV $$");
  EXPECT_EQ(end.how, How::kKilledBySignal);
  EXPECT_EQ(end.code, SIGSEGV);
  EXPECT_EQ(end.messages, "last words\n");
}

TEST(RunChild, KillsWhatTakesTooLongWithAllThatItStarted) {
  const TemporaryFolder folder;
  const auto file = folder / "id";
  const ChildEnd end = runShell("sleep 1000 & echo $! >'" + file.string() + "'; wait", 0.5);
  EXPECT_EQ(end.how, How::kOutOfTime);
  ASSERT_GT(numberIn(file), 0);
  EXPECT_TRUE(endsSoon(numberIn(file)));
}

TEST(RunChild, WaitsForNothingThatAChildLeavesBehind) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(runShell("sleep 1000 & exit 0").code, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(RunChild, KillsTheChildWhereTheTickThrows) {
  const TemporaryFolder folder;
  const auto file = folder / "id";
  struct Stop {};
  const auto tick = [&] {
    if (numberIn(file) > 0) {
      throw Stop{};
    }
  };
  EXPECT_THROW(runShell("echo $$ >'" + file.string() + "'; sleep 1000", 60, tick), Stop);
  EXPECT_FALSE(isAlive(numberIn(file))) << "it has been waited for";
}

TEST(RunChild, HandsOverNoFilesNoInputAndNoSignals) {
  const int leak = fcntl(STDERR_FILENO, F_DUPFD, 20);  // without CLOEXEC
  ASSERT_GE(leak, 20);
  EXPECT_EQ(runShell("cat; ls /proc/self/fd | wc -l").messages, "5\n") << "0 to 3, and the folder itself";
  close(leak);
  signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(runShell("kill -PIPE $$").code, SIGPIPE);
  signal(SIGPIPE, SIG_DFL);
}

TEST(RunChild, SaysWhichProgramCannotBeStarted) {
  EXPECT_THAT(
      [] {
        runChild({"/no/such/program", {}, 1}, [] {});
      },
      ThrowsMessage<WorkError>(HasSubstr("/no/such/program")));
}

TEST(EndWithParent, EndsAChildWhoseParentIsNoMore) {
  EXPECT_EXIT(endWithParent(getppid() + 1), testing::ExitedWithCode(1), "");
}

TEST(EndWithParent, EndsTheChildWhenTheParentIsKilled) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    const pid_t self = getpid();
    if (fork() == 0) {
      endWithParent(self);
      const int id = getpid();
      std::ignore = write(ends[1], &id, sizeof(id));
      pause();
      _exit(0);
    }
    pause();
    _exit(0);
  }
  int child = 0;
  ASSERT_EQ(read(ends[0], &child, sizeof(child)), static_cast<ssize_t>(sizeof(child)));
  EXPECT_TRUE(isAlive(child));
  kill(parent, SIGKILL);
  EXPECT_EQ(waitpid(parent, nullptr, 0), parent);
  // Nobody may wait for the grandchild but the system's first process: a pipe tells of its end.
  close(ends[1]);
  char none = 0;
  EXPECT_EQ(read(ends[0], &none, 1), 0);
  close(ends[0]);
}

}  // namespace
}  // namespace ocelli
