#include "display_driver/device/frame_fence.h"

#include <gtest/gtest.h>

#include <thread>

namespace ocelli {
namespace {

using namespace std::chrono_literals;

TEST(FrameFenceTest, waitEndsWithTheStageOrAnyLaterOne) {
  FrameFence fence(1);
  EXPECT_EQ(fence.wait(FrameStage::kShown, 0us).stage, FrameStage::kWaiting);
  fence.moveTo({.stage = FrameStage::kArrived});
  EXPECT_EQ(fence.wait(FrameStage::kSending, 1h).stage, FrameStage::kArrived);
  EXPECT_EQ(fence.wait(FrameStage::kArrived, 1h).stage, FrameStage::kArrived);
}

TEST(FrameFenceTest, waitEndsWhereTheFrameWillNeverComeThatFar) {
  FrameFence fence(1);
  std::thread device([&] { fence.moveTo({.stage = FrameStage::kLost, .problem = "unplugged"}); });
  EXPECT_EQ(fence.wait(FrameStage::kShown, 1h).problem, "unplugged");
  device.join();
}

TEST(FrameFenceTest, endedFramesStayWhatTheyAre) {
  for (const FrameStage end : {FrameStage::kShown, FrameStage::kDropped, FrameStage::kLost}) {
    FrameFence fence(1);
    fence.moveTo({.stage = end});
    fence.moveTo({.stage = FrameStage::kArrived});
    EXPECT_EQ(fence.state().stage, end);
  }
}

}  // namespace
}  // namespace ocelli
