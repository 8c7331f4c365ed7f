#include "display_driver/device/ideal_screen.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

using namespace std::chrono_literals;

/// 24 slices at 720 rpm, mirrored: a refresh takes 1/24 s, a slice 1/576 s.
class IdealScreenTest : public testing::Test {
 protected:
  FrameNumber add(HostTime now) {
    auto fence = std::make_shared<FrameFence>(static_cast<FrameNumber>(fences.size() + 1));
    fences.push_back(fence);
    screen.add({.fence = fence, .volume = nullptr, .state = {}, .presentation = {}}, now);
    return fence->number();
  }
  HostTime timeOf(uint64_t refresh, int slice = 0) { return screen.rotation().timeOf({refresh, slice}); }
  FrameStage stage(FrameNumber frame) { return fences[frame - 1]->state().stage; }

  DisplayProfile profile = loadProfile("test");
  HostTime start{1s};
  IdealScreen screen{profile, start};
  std::vector<std::shared_ptr<FrameFence>> fences;
};

TEST_F(IdealScreenTest, phasesAndTimesAreEachOthersInverse) {
  const IdealRotation& rotation = screen.rotation();
  EXPECT_EQ(rotation.timeOf({0, 0}), start);
  EXPECT_EQ(rotation.timeOf({24, 0}), start + 1s);
  EXPECT_EQ(rotation.timeOf({0, 12}), start + 20833333ns);  // half of 1/24 s
  for (const RotationPhase phase : {RotationPhase{0, 0}, {0, 1}, {3, 23}, {1000, 0}, {1'000'000, 7}}) {
    const HostTime time = rotation.timeOf(phase);
    EXPECT_EQ(rotation.next(time), phase);
    EXPECT_GT(rotation.next(time + 1ns), phase);
    EXPECT_EQ(rotation.next(time + 1ns, phase.slice), (RotationPhase{phase.refresh + 1, phase.slice}));
  }
  EXPECT_EQ(rotation.next(start - 1h), (RotationPhase{0, 0}));
  EXPECT_EQ(rotation.timeOf({UINT64_MAX, 0}), HostTime::max());
}

TEST_F(IdealScreenTest, readingsTellTheShareOfTheRefresh) {
  const RotationReading reading = screen.rotation().reading(start + 1s + 12500us);
  EXPECT_EQ(reading.refresh, 24u);
  EXPECT_NEAR(reading.share, 0.3, 1e-9);  // 12.5 ms of 41.67 ms
  EXPECT_NEAR(reading.refreshSeconds, 1.0 / 24, 1e-12);
}

TEST_F(IdealScreenTest, aFrameIsShownAtItsPhase) {
  const FrameNumber frame = add(start);
  screen.present(frame, {.at = RotationPhase{5, 7}}, start);
  EXPECT_EQ(screen.nextChange(), timeOf(5, 7));
  EXPECT_TRUE(screen.advance(timeOf(5, 7) - 1ns).empty());
  const auto shown = screen.advance(timeOf(5, 7));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].state.stage, FrameStage::kShown);
  EXPECT_EQ(shown[0].state.shownRefresh, 5u);
  EXPECT_EQ(shown[0].state.shownSlice, 7);
  EXPECT_EQ(shown[0].state.shown, timeOf(5, 7));
  EXPECT_FALSE(shown[0].state.late);
  EXPECT_EQ(screen.underruns(), 0u);
  EXPECT_EQ(screen.nextChange(), HostTime::max());
}

TEST_F(IdealScreenTest, withoutAPhaseTheNextRefreshShowsIt) {
  screen.present(add(start), {}, timeOf(3, 1));
  EXPECT_EQ(screen.nextChange(), timeOf(4));
}

TEST_F(IdealScreenTest, withoutPresentAFrameWaitsUntilANewerOneTakesItsPlace) {
  for (int i = 0; i < 4; ++i) {
    add(start);
  }
  EXPECT_TRUE(screen.advance(start + 1h).empty());
  EXPECT_EQ(stage(1), FrameStage::kDropped);
  EXPECT_EQ(stage(2), FrameStage::kArrived);
  EXPECT_EQ(screen.dropped(), 1u);
}

TEST_F(IdealScreenTest, framesThatHaveATimeAreNotDroppedForThoseThatHaveNone) {
  screen.present(add(start), {.at = RotationPhase{5, 0}}, start);
  for (int i = 0; i < 9; ++i) {
    add(start);
  }
  EXPECT_EQ(stage(1), FrameStage::kArrived);
  EXPECT_EQ(stage(8), FrameStage::kDropped);
  EXPECT_EQ(stage(10), FrameStage::kArrived);
}

TEST_F(IdealScreenTest, theNewestOfThoseThatAreDueIsShown) {
  for (const uint64_t refresh : {2, 2, 4}) {
    screen.present(add(start), {.at = RotationPhase{refresh, 0}}, start);
  }
  const auto shown = screen.advance(timeOf(3));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].fence->number(), 2u);
  EXPECT_EQ(stage(1), FrameStage::kDropped);
  EXPECT_EQ(screen.advance(timeOf(4)).size(), 1u);
}

TEST_F(IdealScreenTest, olderFramesAreNotShownAfterNewerOnes) {
  screen.present(add(start), {.at = RotationPhase{9, 0}}, start);
  screen.present(add(start), {.at = RotationPhase{2, 0}}, start);
  EXPECT_EQ(screen.advance(timeOf(20)).size(), 1u);
  EXPECT_EQ(stage(1), FrameStage::kDropped);
}

TEST_F(IdealScreenTest, aLateFrameWaitsForItsSliceOrTearsTheTurn) {
  const FrameNumber waits = add(start);
  screen.present(waits, {.at = RotationPhase{2, 5}}, timeOf(4, 6));
  EXPECT_EQ(screen.nextChange(), timeOf(5, 5));
  auto shown = screen.advance(timeOf(6));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_TRUE(shown[0].state.late);
  EXPECT_EQ(screen.underruns(), 3u);

  const FrameNumber tears = add(timeOf(6));
  screen.present(tears, {.at = RotationPhase{6, 0}, .tearWhenLate = true}, timeOf(6, 3) - 1us);
  EXPECT_EQ(screen.nextChange(), timeOf(6, 3));
  shown = screen.advance(timeOf(7));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].state.shownSlice, 3);
  EXPECT_EQ(screen.underruns(), 4u);  // a part of a refresh showed an old frame
}

TEST_F(IdealScreenTest, theLastPresentationCounts) {
  const FrameNumber frame = add(start);
  screen.present(frame, {.at = RotationPhase{2, 0}}, timeOf(4, 0) + 1us);
  screen.present(frame, {.at = RotationPhase{8, 0}}, timeOf(4, 1));
  const auto shown = screen.advance(timeOf(9));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].state.shownRefresh, 8u);
  EXPECT_FALSE(shown[0].state.late);
  EXPECT_EQ(screen.underruns(), 0u);
}

}  // namespace
}  // namespace ocelli
