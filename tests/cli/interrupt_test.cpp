#include "cli/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

namespace ocelli {
namespace {

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

TEST(InterruptGuardDeathTest, theSecondSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
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
