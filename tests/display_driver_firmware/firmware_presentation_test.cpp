// When frames are shown, what is shown of them, and what a display does when its buffers are full.
#include <gmock/gmock.h>

#include "tests/display_driver_firmware/firmware_bench.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

using Image = std::vector<std::pair<uint32_t, size_t>>;

/// Slices of whole frames, by the numbers of the frames.
Image slicesOfFrames(const std::vector<uint32_t>& frames) {
  Image image;
  for (size_t i = 0; i < frames.size(); ++i) {
    image.emplace_back(frames[i], frames[i] == 0 ? 0 : i + 1);
  }
  return image;
}

class FirmwarePresentation : public FirmwareBench {
 protected:
  void startWith(int buffers, uint32_t capabilities = 31) {
    FirmwareOptions options = standard();
    options.frameBuffers = buffers;
    options.capabilities = capabilities;
    start(options);
  }
  /// The rest of a frame of which some slices have come.
  void finish(uint32_t frame, const std::vector<size_t>& slices) {
    for (const size_t i : slices) {
      slice(frame, i);
    }
    end(frame);
  }
};

TEST_F(FirmwarePresentation, aFrameIsShownAtItsPhase) {
  whole(1);
  present(1, {2, 4});
  turnTo({2, 3});
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
  step();
  EXPECT_THAT(events(), ElementsAre(isShown(1, {2, 4}, kTorn)));
  turnTo({4, 0});
  EXPECT_EQ(image(1), slicesOfFrames({0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(image(2), slicesOfFrames({0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(image(3), slicesOfFrames({1, 1, 1, 1, 1, 1}));
  ASSERT_EQ(refreshes_[2].parts.size(), 2u);
  EXPECT_EQ(refreshes_[2].parts[1].fromSlice, 4);
  EXPECT_EQ(refreshes_[2].parts[1].frame, 1u);
  EXPECT_EQ(refreshes_[3].parts.size(), 1u);
}

TEST_F(FirmwarePresentation, presentMayStandAnywhereAfterTheBegin) {
  begin(1);
  slice(1, 0);
  present(1, {1, 0});
  finish(1, {1, 2, 3, 4, 5});
  turnTo({1, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0})));
}

TEST_F(FirmwarePresentation, withoutAPhaseItIsShownWhenTheNextRefreshBegins) {
  turnTo({1, 2});
  whole(1);
  present(1, {77, 60000}, kAtNextRefresh);
  turnTo({2, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {2, 0})));
}

TEST_F(FirmwarePresentation, withoutAPhaseItIsNeverLateAndNeverCoarse) {
  begin(1);
  slice(1, 0);
  present(1, {}, kAtNextRefresh | kCoarseWhenLate | kTearWhenLate);
  turnTo({2, 3});
  finish(1, {1, 2, 3, 4, 5});
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {3, 0})));
}

TEST_F(FirmwarePresentation, aFrameWithoutAPresentWaits) {
  whole(1);
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
  present(1, {}, kAtNextRefresh);
  turnTo({4, 0});
  EXPECT_THAT(events(), ElementsAre(isShown(1, {4, 0})));
}

TEST_F(FirmwarePresentation, aLaterPresentTakesThePlaceOfTheFirst) {
  whole(1);
  present(1, {2, 0});
  present(1, {3, 0});
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {3, 0})));
}

TEST_F(FirmwarePresentation, aPresentForAFrameThatIsNotThereMeansNothing) {
  present(1, {1, 0});
  whole(1);
  present(1, {1, 0});
  turnTo({1, 0});
  present(1, {2, 0});  // shown
  present(9, {2, 0});
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0})));
}

TEST_F(FirmwarePresentation, aLateFrameWaitsForItsSlice) {
  begin(1);
  present(1, {1, 2});
  turnTo({1, 4});
  finish(1, {0, 1, 2, 3, 4, 5});
  turnTo({2, 1});
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
  step();
  EXPECT_THAT(events(), ElementsAre(isShown(1, {2, 2}, kLate | kTorn)));
}

TEST_F(FirmwarePresentation, aLateFrameIsShownLaterInTheSameRefreshWhereItsSliceIsStillToCome) {
  turnTo({2, 1});
  whole(1);
  present(1, {1, 3});
  turnTo({2, 3});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {2, 3}, kLate | kTorn)));
}

TEST_F(FirmwarePresentation, thePhaseUnderWayHasCome) {
  turnTo({1, 2});
  whole(1);
  present(1, {1, 2});
  turnTo({2, 2});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {2, 2}, kLate | kTorn)));
}

TEST_F(FirmwarePresentation, aLateFrameTearsWhereItMay) {
  begin(1);
  present(1, {1, 0}, kTearWhenLate);
  turnTo({1, 2});
  finish(1, {0, 1, 2, 3, 4, 5});
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
  step();
  EXPECT_THAT(events(), ElementsAre(isShown(1, {1, 3}, kLate | kTorn)));
  turnTo({2, 0});
  EXPECT_EQ(image(1), slicesOfFrames({0, 0, 0, 1, 1, 1}));
}

TEST_F(FirmwarePresentation, withTheFlagAFrameInTimeIsNotTorn) {
  whole(1);
  present(1, {1, 0}, kTearWhenLate | kCoarseWhenLate);
  turnTo({1, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0})));
}

TEST_F(FirmwarePresentation, severalFramesInOneRefresh) {
  whole(1);
  present(1, {1, 1});
  turnTo({1, 1});
  whole(2);
  present(2, {1, 3});
  turnTo({1, 3});
  whole(3);
  present(3, {1, 4});
  turnTo({2, 0});
  EXPECT_EQ(image(1), slicesOfFrames({0, 1, 1, 2, 3, 3}));
  EXPECT_EQ(refreshes_[1].parts.size(), 4u);
}

TEST_F(FirmwarePresentation, aLateFrameIsShownCoarseWhereItMay) {
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({1, 0});
  begin(2);
  slice(2, 1);
  slice(2, 4);
  present(2, {2, 0}, kCoarseWhenLate);
  turnTo({2, 3});
  slice(2, 0);  // is not shown before the frame is whole
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {1, 0}), isShown(2, {2, 0}, kCoarse)));
  finish(2, {2, 3, 5});
  turnTo({4, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(2), isShown(2, {3, 0}, kLate)));
  EXPECT_EQ(image(2), (Image{{2, 2}, {2, 2}, {2, 2}, {2, 5}, {2, 5}, {2, 5}}));
  EXPECT_TRUE(refreshes_[2].parts[0].coarse);
  EXPECT_EQ(image(3), slicesOfFrames({2, 2, 2, 2, 2, 2}));
  EXPECT_FALSE(refreshes_[3].parts[0].coarse);
  EXPECT_EQ(u32(telemetry(), 44), 2u);
}

TEST_F(FirmwarePresentation, theLowerOfTwoNearestSlices) {
  begin(1);
  slice(1, 1);
  slice(1, 5);
  present(1, {1, 0}, kCoarseWhenLate);
  turnTo({2, 0});
  EXPECT_EQ(image(1), (Image{{1, 2}, {1, 2}, {1, 2}, {1, 2}, {1, 6}, {1, 6}}));
}

TEST_F(FirmwarePresentation, slicesOfTheBaseAreThereAsWell) {
  whole(1);
  begin(2, 1, some({0, 1, 2, 3}));
  slice(2, 0);
  present(2, {1, 0}, kCoarseWhenLate);
  turnTo({2, 0});
  EXPECT_EQ(image(1), (Image{{2, 1}, {2, 1}, {2, 1}, {1, 5}, {1, 5}, {1, 6}}));
}

TEST_F(FirmwarePresentation, withoutAnySliceNothingIsShownCoarse) {
  begin(1);
  present(1, {1, 0}, kCoarseWhenLate);
  turnTo({1, 3});
  EXPECT_THAT(events(), IsEmpty());
  slice(1, 3);
  turnTo({2, 0});
  EXPECT_THAT(events(), ElementsAre(isShown(1, {2, 0}, kCoarse | kLate)));
}

TEST_F(FirmwarePresentation, coarseAndThenTorn) {
  begin(1);
  slice(1, 0);
  present(1, {1, 0}, kCoarseWhenLate | kTearWhenLate);
  turnTo({1, 1});
  finish(1, {1, 2, 3, 4, 5});
  turnTo({2, 0});
  EXPECT_THAT(events(), ElementsAre(isShown(1, {1, 0}, kCoarse), isArrived(1), isShown(1, {1, 2}, kLate | kTorn)));
  EXPECT_EQ(image(1), (Image{{1, 1}, {1, 1}, {1, 3}, {1, 4}, {1, 5}, {1, 6}}));
}

TEST_F(FirmwarePresentation, aCoarseFrameThatIsLostStaysUntilTheNext) {
  begin(1);
  slice(1, 2);
  present(1, {1, 0}, kCoarseWhenLate);
  turnTo({1, 2});
  end(1);
  turnTo({3, 0});
  EXPECT_THAT(events(), ElementsAre(isShown(1, {1, 0}, kCoarse), isError(10, 1)));
  EXPECT_EQ(image(2), (Image(kSlices, {1, 3})));
  whole(2);
  present(2, {}, kAtNextRefresh);
  turnTo({4, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(2), isShown(2, {4, 0})));
}

TEST_F(FirmwarePresentation, aDisplayThatShowsNothingCoarseDoesNot) {
  startWith(3, 31 - 8);
  begin(1);
  slice(1, 0);
  present(1, {1, 0}, kCoarseWhenLate);
  turnTo({2, 0});
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(FirmwarePresentation, aDisplayThatChangesAtSliceZeroRefusesOthers) {
  startWith(3, 31 - 16);
  begin(1);
  present(1, {1, 2});
  EXPECT_THAT(events(), ElementsAre(isError(4, 1)));
  begin(2);
  present(2, {1, 2}, kAtNextRefresh);  // the slice means nothing
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(FirmwarePresentation, aDisplayThatChangesAtSliceZeroTearsNothing) {
  startWith(3, 31 - 16);
  begin(1);
  present(1, {1, 0}, kTearWhenLate);
  turnTo({1, 2});
  finish(1, {0, 1, 2, 3, 4, 5});
  turnTo({2, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {2, 0}, kLate)));
}

TEST_F(FirmwarePresentation, theNewestOfThoseThatAreDue) {
  startWith(4);
  whole(1);
  whole(2);
  whole(3);
  present(3, {1, 0});
  present(2, {1, 0});
  present(1, {1, 0});
  turnTo({1, 0});
  EXPECT_THAT(events(),
              ElementsAre(isArrived(1), isArrived(2), isArrived(3), isDropped(1), isDropped(2), isShown(3, {1, 0})));
  EXPECT_EQ(u32(telemetry(), 48), 2u);
}

TEST_F(FirmwarePresentation, aCoarseFrameIsNewerThanAWholeOne) {
  whole(1);
  present(1, {1, 0});
  begin(2);
  slice(2, 0);
  present(2, {1, 0}, kCoarseWhenLate);
  turnTo({1, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isDropped(1), isShown(2, {1, 0}, kCoarse)));
}

TEST_F(FirmwarePresentation, newerOnesThatWaitStay) {
  startWith(4);
  whole(1);
  whole(2);
  present(1, {1, 0});
  present(2, {2, 0});
  turnTo({2, 0});
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isArrived(2), isShown(1, {1, 0}), isShown(2, {2, 0})));
}

class FullBuffers : public FirmwarePresentation, public testing::WithParamInterface<int> {};

TEST_P(FullBuffers, theDisplayTakesNothingUntilABufferIsFree) {
  const int buffers = GetParam();
  startWith(buffers);
  // What is shown takes one, the others wait for their phases.
  for (int frame = 1; frame < buffers; ++frame) {
    whole(static_cast<uint32_t>(frame));
    present(static_cast<uint32_t>(frame), {static_cast<uint64_t>(frame), 0});
  }
  const auto next = static_cast<uint32_t>(buffers);
  Bytes rest = wholeBytes(next);
  const size_t taken = offer(rest);
  EXPECT_EQ(taken, 32u + 8 + 1) << "the FRAME_BEGIN and no more";
  rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(taken));
  EXPECT_EQ(offer(rest), 0u);
  turnTo({0, 5});
  EXPECT_EQ(offer(rest), 0u);
  events();
  step();  // frame 1 is shown: what was shown before gives its buffer
  EXPECT_EQ(offer(rest), rest.size());
  EXPECT_THAT(events(), ElementsAre(isShown(1, {1, 0}), isArrived(next)));
}

TEST_P(FullBuffers, aFrameThatWaitsWithoutAPresentGivesWay) {
  const int buffers = GetParam();
  startWith(buffers);
  for (int frame = 1; frame <= buffers + 1; ++frame) {
    whole(static_cast<uint32_t>(frame));
  }
  std::vector<SeenEvent> dropped;
  for (const SeenEvent& event : events()) {
    if (event.type == kDropped) {
      dropped.push_back(event);
    }
  }
  EXPECT_THAT(dropped, ElementsAre(isDropped(1), isDropped(2)));
}

TEST_P(FullBuffers, theBaseDoesNotGiveWay) {
  const int buffers = GetParam();
  startWith(buffers);
  for (int frame = 1; frame < buffers; ++frame) {
    whole(static_cast<uint32_t>(frame));
  }
  events();
  const auto next = static_cast<uint32_t>(buffers);
  begin(next, 1);
  if (buffers == 2) {
    EXPECT_THAT(events(), ElementsAre(isError(8, 2)));
  } else {
    EXPECT_THAT(events(), ElementsAre(isDropped(2)));
  }
}

INSTANTIATE_TEST_SUITE_P(Buffers, FullBuffers, testing::Values(2, 3, 4));

TEST_F(FirmwarePresentation, theBaseIsLookedForWhenABufferIsFree) {
  startWith(2);
  whole(1);
  present(1, {}, kAtNextRefresh);
  turnTo({1, 0});
  whole(2);
  present(2, {2, 0});
  // 1 is shown and 2 waits for its phase: when it has come, 1 is gone.
  EXPECT_EQ(offer(message(kFrameBegin, 3, frameBeginPayload(1, all()))), 32u + 8 + 1);
  events();
  turnTo({2, 0});
  EXPECT_EQ(offer({}), 0u);
  EXPECT_THAT(events(), ElementsAre(isShown(2, {2, 0}), isError(8, 3)));
}

TEST_F(FirmwarePresentation, aNewSessionEndsTheWait) {
  startWith(2);
  whole(1);
  present(1, {1000000, 0});
  const Bytes next = wholeBytes(2);
  EXPECT_LT(offer(next), next.size());
  arm(5);
  whole(1);
  EXPECT_THAT(events(), ElementsAre(isArrived(1)));
}

TEST_F(FirmwarePresentation, slicesThatNobodyAskedAboutAreTurnedThroughAsWell) {
  whole(1);
  present(1, {2, 3});
  now_ = firmware_->rotor().begin() + static_cast<DeviceMicroseconds>(10.5e6 / standard().profile.refreshHertz());
  firmware_->advance(now_);  // as one step
  EXPECT_THAT(events(), ElementsAre(isArrived(1), isShown(1, {2, 3}, kTorn)));
  EXPECT_EQ(refreshes_.size(), 10u);
  EXPECT_EQ(image(2), slicesOfFrames({0, 0, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace ocelli::test
