#include "display_driver/pacing/rotation_clock.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

constexpr double kClockRefresh = 1.0 / 24;

HostTime at(double seconds) {
  return HostTime(1000s) + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

double secondsOf(HostTime time) {
  return std::chrono::duration<double>(time - at(0)).count();
}

/// What a display would tell at this many refreshes.
RotationReading reading(double seconds, double refreshes) {
  return {.time = at(seconds),
          .refresh = static_cast<uint64_t>(refreshes),
          .share = refreshes - std::floor(refreshes),
          .refreshSeconds = kClockRefresh};
}

double uniform(Random& random, double from, double to) {
  return static_cast<double>(random.inRange(static_cast<float>(from), static_cast<float>(to)));
}

TEST(RotationClockTest, oneReadingAndTheRateOfTheDisplayAreEnough) {
  RotationClock clock(kClockRefresh);
  EXPECT_FALSE(clock.running());
  clock.add({.time = at(1), .refresh = 10, .share = 0.5});
  ASSERT_TRUE(clock.running());
  EXPECT_NEAR(clock.refreshesAt(at(1)), 10.5, 1e-9);
  EXPECT_NEAR(secondsOf(clock.beginOf(12)), 1 + 1.5 * kClockRefresh, 2e-9);
  EXPECT_EQ(clock.refreshAfter(at(1)), 11u);
}

TEST(RotationClockTest, timesAndRefreshesAreEachOthersInverse) {
  RotationClock clock(kClockRefresh);
  clock.add(reading(0, 1'000'000.25));
  for (const uint64_t refresh : {1'000'001u, 1'000'100u, 1'010'000u}) {
    EXPECT_EQ(clock.refreshAfter(clock.beginOf(refresh)), refresh);
    EXPECT_EQ(clock.refreshAfter(clock.beginOf(refresh) + 1ns), refresh + 1);
    EXPECT_NEAR(clock.refreshesAt(clock.beginOf(refresh)), static_cast<double>(refresh), 1e-6);
  }
}

TEST(RotationClockTest, exactReadingsOfAnyConstantRateAreFoundExactly) {
  for (const double factor : {0.98, 1.0, 1.015}) {
    RotationClock clock(kClockRefresh);
    for (int i = 0; i < 200; ++i) {
      const double seconds = 0.05 * i;
      clock.add(reading(seconds, 3 + seconds / (kClockRefresh * factor)));
    }
    // After 10 s the first guess of the rate has no weight left.
    EXPECT_NEAR(clock.refreshSeconds(), kClockRefresh * factor, 1e-5 * kClockRefresh);
    EXPECT_NEAR(clock.refreshesAt(at(10.5)), 3 + 10.5 / (kClockRefresh * factor), 1e-3);
    EXPECT_EQ(clock.restarts(), 0u);
  }
}

/// Jitter of readings is evenly distributed within +-a: its standard deviation is a / sqrt(3).
TEST(RotationClockTest, jitteredReadingsGiveLessJitterThanTheyHave) {
  const double jitter = 0.004;
  Random random(1);
  RotationClock clock(kClockRefresh);
  double squares = 0;
  double expected = 0;
  int count = 0;
  for (int i = 0; i < 2000; ++i) {
    const double seconds = 0.05 * i;
    const double refreshes = 5 + seconds / kClockRefresh;
    clock.add(reading(seconds + uniform(random, -jitter, jitter), refreshes));
    if (i > 100) {
      const double ahead = seconds + 0.06;
      const double error = (clock.refreshesAt(at(ahead)) - (5 + ahead / kClockRefresh)) * kClockRefresh;
      squares += error * error;
      expected += clock.uncertaintySeconds(at(ahead)) * clock.uncertaintySeconds(at(ahead));
      ++count;
    }
  }
  const double deviation = std::sqrt(squares / count);
  EXPECT_LT(deviation, 0.6 * jitter / std::sqrt(3));
  // It allows for a motor that wanders, which this one does not: it is surer than it says, but not by much.
  EXPECT_LT(deviation, std::sqrt(expected / count));
  EXPECT_GT(deviation, 0.3 * std::sqrt(expected / count));
  EXPECT_EQ(clock.restarts(), 0u);
}

TEST(RotationClockTest, aDriftingMotorIsFollowed) {
  Random random(2);
  RotationClock clock(kClockRefresh);
  // The rate rises by 0.2 % a second for ten seconds.
  for (int i = 0; i < 200; ++i) {
    const double t = 0.05 * i;
    const double refreshes = (t + 0.001 * t * t) / kClockRefresh;
    clock.add(reading(t + uniform(random, -0.001, 0.001), refreshes));
    if (i > 40) {
      // Half a slice of 198: what a viewer cannot see.
      EXPECT_NEAR(clock.refreshesAt(at(t + 0.05)), (t + 0.05 + 0.001 * (t + 0.05) * (t + 0.05)) / kClockRefresh, 0.02);
    }
  }
  EXPECT_EQ(clock.restarts(), 0u);
}

TEST(RotationClockTest, singleWrongReadingsAreLeftOut) {
  RotationClock clock(kClockRefresh);
  for (int i = 0; i < 200; ++i) {
    const double seconds = 0.05 * i;
    const double wrong = i % 10 == 9 ? 0.3 : 0;  // told 0.3 refreshes late
    clock.add(reading(seconds, 10 + seconds / kClockRefresh - wrong));
  }
  EXPECT_NEAR(clock.refreshesAt(at(10)), 10 + 10 / kClockRefresh, 0.003);
  EXPECT_EQ(clock.restarts(), 0u);
}

TEST(RotationClockTest, missingReadingsMakeItLessSure) {
  RotationClock clock(kClockRefresh);
  for (int i = 0; i < 100; ++i) {
    clock.add(reading(0.05 * i, 0.05 * i / kClockRefresh));
  }
  const double soon = clock.uncertaintySeconds(at(5));
  EXPECT_LT(soon, 0.0005);
  EXPECT_GT(clock.uncertaintySeconds(at(10)), 2 * soon);
  EXPECT_GT(clock.uncertaintySeconds(at(60)), kClockRefresh);
}

TEST(RotationClockTest, aRestartedRotationIsFoundAgain) {
  RotationClock clock(kClockRefresh);
  for (int i = 0; i < 100; ++i) {
    clock.add(reading(0.05 * i, 1000 + 0.05 * i / kClockRefresh));
  }
  for (int i = 0; i < 40; ++i) {
    clock.add(reading(8 + 0.05 * i, 0.4 + 0.05 * i / kClockRefresh));
  }
  EXPECT_EQ(clock.restarts(), 1u);
  EXPECT_NEAR(clock.refreshesAt(at(10)), 0.4 + 2 / kClockRefresh, 0.01);
}

TEST(RotationClockTest, oldAndRepeatedReadingsAreLeftOut) {
  RotationClock clock(kClockRefresh);
  for (int i = 0; i < 100; ++i) {
    clock.add(reading(0.05 * i, 0.05 * i / kClockRefresh));
    clock.add(reading(0.05 * i, 500));
    clock.add(reading(0.05 * i - 0.01, 700));
  }
  EXPECT_EQ(clock.restarts(), 0u);
  EXPECT_NEAR(clock.refreshesAt(at(5)), 5 / kClockRefresh, 1e-3);
}

}  // namespace
}  // namespace ocelli
