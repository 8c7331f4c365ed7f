// Timestamps of live feeds, which count from whenever they began.
#include "oc_core/feeds_live/feed_clock.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(FeedClock, leavesRecordedTimesAlone) {
  FeedClock clock(FeedClock::Kind::kRecorded);
  EXPECT_EQ(clock.placeSeconds(3.5, 100), 3.5);
  EXPECT_EQ(clock.placeSeconds(3.6, 200), 3.6);
}

TEST(FeedClock, liveFramesAreAsOldAsTheLeastDelayedOneSays) {
  FeedClock clock(FeedClock::Kind::kLive);
  EXPECT_NEAR(clock.placeSeconds(10.0, 100.4), 100.4, 1e-9);
  EXPECT_NEAR(clock.placeSeconds(10.1, 100.2), 100.2, 1e-9) << "the first one was delayed by 0.3 s";
  EXPECT_NEAR(clock.placeSeconds(10.2, 100.9), 100.3, 1e-3) << "this one by 0.6 s";
}

TEST(FeedClock, followsAClockThatRunsSlowly) {
  FeedClock clock(FeedClock::Kind::kLive);
  double seconds = 0;
  for (int k = 0; k <= 36000; ++k) {
    const double now = 0.1 * k;
    seconds = clock.placeSeconds(now * (1 - 5e-4), now);
  }
  EXPECT_NEAR(seconds, 3600, 0.01) << "it lost 1.8 s in an hour";
}

TEST(FeedClock, beginsAnewWhereTimestampsJump) {
  FeedClock clock(FeedClock::Kind::kLive);
  clock.placeSeconds(500, 1000);
  EXPECT_NEAR(clock.placeSeconds(0, 1010), 1010, 1e-9);
  EXPECT_NEAR(clock.placeSeconds(900, 1011), 1011, 1e-9);
}

TEST(FeedClock, replayedFilesBeginNow) {
  FeedClock clock(FeedClock::Kind::kReplayed);
  EXPECT_NEAR(clock.placeSeconds(2, 50), 50, 1e-9);
  EXPECT_NEAR(clock.placeSeconds(4, 50.1), 52, 1e-9) << "it is read faster than it was taken";
}

}  // namespace
}  // namespace ocelli
