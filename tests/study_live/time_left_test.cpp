#include "study/live/time_left.h"

#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

TEST(TimeLeft, isTheProtocolsUntilThePaceIsKnown) {
  TimeLeft left(20);
  EXPECT_EQ(left.seconds(6), 120);
  EXPECT_FALSE(left.knowsPace());
  for (const int64_t end : {5, 15, 25}) {  // two times from end to end
    left.trialCompleted(end * kSecond);
  }
  EXPECT_EQ(left.seconds(6), 120);
  left.trialCompleted(35 * kSecond);
  EXPECT_TRUE(left.knowsPace());
  EXPECT_DOUBLE_EQ(left.seconds(6), 60);
  EXPECT_EQ(left.seconds(0), 0);
}

TEST(TimeLeft, doesNotCountALongBreakNorAnInterruption) {
  TimeLeft left(20);
  for (const int64_t end : {0, 10, 20, 620, 630}) {  // ten minutes of a break once
    left.trialCompleted(end * kSecond);
  }
  EXPECT_DOUBLE_EQ(left.seconds(2), 20);
  TimeLeft paused(20);
  int64_t now = 0;
  for (int i = 0; i < 4; ++i) {
    paused.trialCompleted(now);
    paused.trialCompleted(now + 4 * kSecond);
    paused.interrupted();
    now += 900 * kSecond;
  }
  EXPECT_DOUBLE_EQ(paused.seconds(3), 12);
}

}  // namespace
}  // namespace ocelli::test
