#include "study/screen/clock_watch.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

TEST(ClockWatch, noticesAClockThatIsSet) {
  ClockWatch watch;
  EXPECT_FALSE(watch.look(1000 * kSecond, 5 * kSecond));
  EXPECT_FALSE(watch.look(1016 * kSecond, 21 * kSecond));
  EXPECT_EQ(watch.look(1020 * kSecond, 22 * kSecond), 3 * kSecond);
  EXPECT_FALSE(watch.look(1021 * kSecond, 23 * kSecond)) << "once";
  EXPECT_EQ(watch.look(421 * kSecond, 23 * kSecond), -600 * kSecond);
}

TEST(ClockWatch, takesDriftForNone) {
  ClockWatch watch;
  for (int64_t minute = 0; minute < 600; ++minute) {
    // Ten milliseconds a minute, which are six seconds in the end.
    EXPECT_FALSE(watch.look(minute * (60 * kSecond + kSecond / 100), minute * 60 * kSecond));
  }
}

TEST(ClockWatch, takesASecondForAJump) {
  ClockWatch watch;
  EXPECT_FALSE(watch.look(0, 0));
  EXPECT_FALSE(watch.look(kSecond - 1, 0));
  EXPECT_TRUE(watch.look(2 * kSecond - 1, 0));
}

}  // namespace
}  // namespace ocelli
