// The window on a (virtual) screen, beside a thread that runs the feeds.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "oc_core/feeds_window/feeds_window.h"
#include "tests/feeds_window/composed_frames.h"

namespace ocelli::test {
namespace {

bool hasDisplay() {
  return std::getenv("DISPLAY") != nullptr;
}

TEST(FeedsWindowRun, showsUntilItIsClosedAndEndsTheRun) {
  if (!hasDisplay()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  ComposedFrames frames;
  size_t shown = 0;
  int turns = 0;
  FeedsWindowOptions options;
  options.hasRedErased = true;
  options.goesOn = [&] { return ++turns < 20; };
  runFeedsWindow(frames.graph(), options, [&](FeedsScreen& screen) {
    EXPECT_EQ(screen.erased(), ErasedLook::kRed) << "from the first image on";
    while (!screen.isClosed()) {
      screen.show(frames.frame(0.1 * static_cast<double>(shown), 9));
      ++shown;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  });
  EXPECT_EQ(turns, 20);
  EXPECT_GT(shown, 0u);
}

TEST(FeedsWindowRun, throwsWhatTheRunThrows) {
  if (!hasDisplay()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const ComposedFrames frames;
  EXPECT_THROW(runFeedsWindow(frames.graph(), {}, [](FeedsScreen&) { throw std::domain_error("no feed"); }),
               std::domain_error);
}

}  // namespace
}  // namespace ocelli::test
