#include "oc_core/feeds_window/feeds_screen.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/feeds_window/composed_frames.h"

namespace ocelli::test {
namespace {

/// Long enough for a thread to go on by mistake, and short enough for a test.
constexpr std::chrono::milliseconds kWhile{50};

TEST(FeedsScreen, handsOnTheNewestImageOnce) {
  ComposedFrames frames;
  int woken = 0;
  FeedsScreen screen(false, [&] { ++woken; });
  EXPECT_FALSE(screen.take());
  screen.show(frames.frame(7.0, 1));
  screen.show(frames.frame(7.5, 2));
  const auto shown = screen.take();
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->image(0, 0), Rgb8(2));
  EXPECT_DOUBLE_EQ(shown->seconds, 0.5) << "since the first image";
  EXPECT_EQ(shown->labels.size(), 3u);
  EXPECT_FALSE(screen.take());
  EXPECT_EQ(woken, 2);
}

TEST(FeedsScreen, theRunWaitsWhileItIsPaused) {
  ComposedFrames frames;
  FeedsScreen screen(false);
  screen.setPaused(true);
  std::atomic<int> shown = 0;
  std::thread run([&] {
    for (int k = 0; k < 3; ++k) {
      screen.show(frames.frame(k, k));
      ++shown;
    }
  });
  std::this_thread::sleep_for(kWhile);
  EXPECT_EQ(shown, 0);
  screen.step();
  std::this_thread::sleep_for(kWhile);
  EXPECT_EQ(shown, 1) << "one image further";
  screen.setErased(ErasedLook::kRed);
  std::this_thread::sleep_for(kWhile);
  EXPECT_EQ(shown, 2) << "so that it is seen";
  EXPECT_EQ(screen.erased(), ErasedLook::kRed);
  screen.setPaused(false);
  run.join();
  EXPECT_EQ(shown, 3);
}

TEST(FeedsScreen, closingEndsAPause) {
  ComposedFrames frames;
  FeedsScreen screen(false);
  screen.setPaused(true);
  std::thread run([&] {
    screen.show(frames.frame(0, 0));
    screen.end();
  });
  screen.close();
  run.join();
  EXPECT_TRUE(screen.isClosed());
  EXPECT_TRUE(screen.hasEnded());
}

TEST(FeedsScreen, liveFeedsDoNotWait) {
  ComposedFrames frames;
  FeedsScreen screen(true);
  screen.setPaused(true);
  EXPECT_FALSE(screen.isPaused());
  screen.show(frames.frame(0, 0));  // would wait for ever
}

}  // namespace
}  // namespace ocelli::test
