#include "study/session/frame_timing.h"

#include <gtest/gtest.h>

#include "study/session/utc_time.h"

namespace ocelli {
namespace {

const TimingLimits kLimits{};  // late from 1.2 intervals on; 1 % of frames may be dropped

TEST(FrameTiming, countsIntervalsBeyondTheLimit) {
  const std::vector<int64_t> shown{0, 100, 220, 341, 441};  // 100, 120, 121, 100
  const TrialTiming timing = timingOf(shown, kLimits, {.intervalNanoseconds = 100});
  EXPECT_EQ(timing.frames, 5);
  EXPECT_EQ(timing.dropped, 1);
  EXPECT_EQ(timing.medianNanoseconds, 120);  // the upper one of two
  EXPECT_EQ(timing.longestNanoseconds, 121);
  EXPECT_EQ(timing.verdict, TimingVerdict::kDroppedFrames);
}

TEST(FrameTiming, aFewMayBeDropped) {
  std::vector<int64_t> shown{0};
  for (int i = 0; i < 199; ++i) {
    shown.push_back(shown.back() + (i == 50 || i == 70 ? 200 : 100));
  }
  EXPECT_EQ(timingOf(shown, kLimits, {.intervalNanoseconds = 100}).verdict, TimingVerdict::kGood);
  shown.back() += 100;
  EXPECT_EQ(timingOf(shown, kLimits, {.intervalNanoseconds = 100}).verdict, TimingVerdict::kDroppedFrames);
}

TEST(FrameTiming, framesThatDoNotWaitForTheScreenAreEarly) {
  const auto verdict = [](int64_t interval) {
    std::vector<int64_t> shown;
    for (int64_t i = 0; i < 50; ++i) {
      shown.push_back(i * interval);
    }
    return timingOf(shown, kLimits, {.intervalNanoseconds = 1200}).verdict;
  };
  EXPECT_EQ(verdict(1000), TimingVerdict::kGood);  // 1200 / 1.2
  EXPECT_EQ(verdict(999), TimingVerdict::kEarlyFrames);
  EXPECT_EQ(verdict(1), TimingVerdict::kEarlyFrames);
  // One frame has no intervals.
  EXPECT_EQ(timingOf(std::vector<int64_t>{7}, kLimits, {.intervalNanoseconds = 1200}).verdict, TimingVerdict::kGood);
}

TEST(FrameTiming, saysWhereItCannotBeTrusted) {
  EXPECT_EQ(timingOf({}, kLimits, {}).verdict, TimingVerdict::kGood);
  EXPECT_EQ(timingOf({}, kLimits, {.unstable = true}).verdict, TimingVerdict::kUnstableRefresh);
  EXPECT_EQ(timingOf({}, kLimits, {.unstable = true, .simulated = true}).verdict, TimingVerdict::kSimulatedClock);
}

TEST(UtcTime, isIso8601) {
  EXPECT_EQ(utcText(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(utcText(951'827'696'789), "2000-02-29T12:34:56.789Z");
  EXPECT_EQ(utcNow().size(), utcText(0).size());
  EXPECT_GT(utcNow(), "2020");
}

}  // namespace
}  // namespace ocelli
