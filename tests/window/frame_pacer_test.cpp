#include "oc_core/window/frame_pacer.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr double kRounding = 1e-12;  // of sums of seconds in double

TEST(FramePacerTest, makesSixtyFramesASecondWhereTheScreenSaysNothing) {
  FramePacer pacer(0);
  double now = 100;
  EXPECT_EQ(pacer.wait(now), 0) << "the first frame";
  for (int i = 1; i <= 60; ++i) {
    now += 0.001;  // what drawing takes
    now += pacer.wait(now);
  }
  EXPECT_NEAR(now, 101, kRounding * 100);
}

TEST(FramePacerTest, leavesAScreenAloneThatWaitsItself) {
  for (const double trueRate : {59.9, 60.0, 60.1}) {
    FramePacer pacer(60);
    double now = 0;
    for (int i = 0; i < 1000; ++i) {
      now += 1 / trueRate;
      ASSERT_EQ(pacer.wait(now), 0) << trueRate;
    }
  }
}

TEST(FramePacerTest, holdsBackWhatOutrunsTheScreen) {
  FramePacer pacer(50);
  pacer.wait(0);
  EXPECT_NEAR(pacer.wait(0.004), 0.95 * 0.020 - 0.004, kRounding);
}

TEST(FramePacerTest, doesNotMakeUpForSlowFrames) {
  FramePacer pacer(0);
  pacer.wait(0);
  EXPECT_EQ(pacer.wait(1), 0);
  EXPECT_NEAR(pacer.wait(1.001), 1.0 / 60 - 0.001, kRounding);
}

TEST(FramePacerTest, neverWaitsLongWhereTheClockWasSetBack) {
  FramePacer pacer(0);
  pacer.wait(1000);
  EXPECT_LE(pacer.wait(0), 1.0 / 60);
}

}  // namespace
}  // namespace ocelli
