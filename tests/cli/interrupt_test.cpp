#include "cli/interrupt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

/// Then a signal is another one.
constexpr std::chrono::milliseconds kLater(300);

TEST(InterruptGuard, aSignalThatComesTwiceAtOnceIsOne) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const InterruptGuard guard;
    std::raise(signal);
    std::raise(signal);
    EXPECT_TRUE(InterruptGuard::interrupted());
  }
}

TEST(InterruptGuard, notesTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const InterruptGuard guard;
    EXPECT_FALSE(InterruptGuard::interrupted());
    EXPECT_NO_THROW(InterruptGuard::check());
    std::raise(signal);
    EXPECT_TRUE(InterruptGuard::interrupted());
    EXPECT_THROW(InterruptGuard::check(), Interrupted);
  }
}

TEST(RunOrLeaveNothing, anInterruptEndsTheWorkAtItsNextReport) {
  double reached = -1;
  const Progress bar = [&](std::string_view, double fraction) { reached = fraction; };
  try {
    runOrLeaveNothing("x.svol", bar, [](const Progress& progress) {
      progress("working", 0.25);
      std::raise(SIGINT);
      progress("working", 0.5);
    });
    FAIL();
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("x.svol: interrupted"));
  }
  EXPECT_EQ(reached, 0.25);
  runOrLeaveNothing("x.svol", bar, [](const Progress& progress) { progress("working", 1); });
  EXPECT_EQ(reached, 1);
}

TEST(InterruptGuardDeathTest, theSecondSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGINT);
        std::this_thread::sleep_for(kLater);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptGuardDeathTest, theSecondSignalTakesWhatIsHalfWrittenAlong) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        removeUnfinishedOutputsOnSignals();
        const InterruptGuard guard;
        OutputFile file(folder / "a");
        std::raise(SIGTERM);
        std::this_thread::sleep_for(kLater);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(InterruptGuardDeathTest, withoutAGuardTheFirstSignalDoes) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        removeUnfinishedOutputsOnSignals();
        { const InterruptGuard guard; }
        OutputFile file(folder / "a");
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(InterruptGuard, aTerminalThatGoesMaySayItTwice) {
  const InterruptGuard guard;
  std::raise(SIGHUP);
  std::raise(SIGHUP);
  EXPECT_TRUE(InterruptGuard::interrupted());
}

TEST(InterruptGuardDeathTest, withoutItTheFirstOneDoes) {
  EXPECT_EXIT(
      {
        { const InterruptGuard guard; }
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptGuard, leavesAnIgnoredSignalIgnored) {
  std::signal(SIGINT, SIG_IGN);
  {
    const InterruptGuard guard;
    std::raise(SIGINT);
    EXPECT_FALSE(InterruptGuard::interrupted());
  }
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN);
}

}  // namespace
}  // namespace ocelli
