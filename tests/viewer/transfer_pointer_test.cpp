// What the pointer and keys do in the pane of the transfer function.
#include "display_sim/viewer/transfer_pointer.h"

#include <gmock/gmock.h>

#include <set>
#include <tuple>

#include "display_sim/viewer/transfer_keys.h"
#include "display_sim/viewer/viewer_keys.h"
#include "tests/viewer/transfer_state.h"

namespace ocelli {
namespace {

using test::transferState;

/// 500 wide and 200 high: a value of 1 is 5 pixels.
constexpr TransferFrame kTransferFrame{{100, 50}, {500, 200}, {0, 100}, 1};

TransferFrame transferFrameOf(const ViewerState& state) {
  TransferFrame frame = kTransferFrame;
  frame.axis = state.volume.axis;
  return frame;
}

void dragTransfer(ViewerState& state, TransferPointer& pointer, const glm::dvec2& from, const glm::dvec2& to) {
  pointer.press(state, transferFrameOf(state), from);
  pointer.move(state, transferFrameOf(state), to);
  pointer.release(state);
}

TEST(TransferPointer, placesAndValuesAreEachOthersInverse) {
  EXPECT_EQ(kTransferFrame.placeOf(0, 1), glm::dvec2(100, 50));
  EXPECT_EQ(kTransferFrame.placeOf(100, 0), glm::dvec2(600, 250));
  EXPECT_EQ(kTransferFrame.valueAt(kTransferFrame.placeOf(30, 0.2)), 30);
  EXPECT_DOUBLE_EQ(kTransferFrame.opacityAt(kTransferFrame.placeOf(30, 0.2)), 0.2);
}

TEST(TransferPointer, dragsThePointUnderIt) {
  ViewerState state = transferState();
  TransferPointer pointer;
  // Beside its middle, (350, 150): it moves as far as the pointer, and does not jump there.
  dragTransfer(state, pointer, {353, 148}, {403, 108});
  EXPECT_EQ(state.volume.transfer->chosen(), 1U);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 60);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].opacity, 0.7);
  dragTransfer(state, pointer, {403, 108}, {900, 0});
  EXPECT_EQ(state.volume.transfer->points()[1].value, 100) << "stops at its neighbour";
  EXPECT_TRUE(state.volume.transfer->undo());
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 60) << "one drag is one step";
}

TEST(TransferPointer, aClickThatDoesNotMoveChangesNothing) {
  ViewerState state = transferState();
  TransferPointer pointer;
  dragTransfer(state, pointer, {351, 151}, {351, 151});
  EXPECT_EQ(state.volume.transfer->chosen(), 1U);
  EXPECT_FALSE(state.volume.transfer->canUndo());
  dragTransfer(state, pointer, {200, 60}, {200, 60});
  EXPECT_EQ(state.volume.transfer->chosen(), std::nullopt) << "beside all of them";
}

TEST(TransferPointer, aDoubleClickAddsAPointWhereItIs) {
  ViewerState state = transferState();
  TransferPointer pointer;
  const glm::dvec2 at = kTransferFrame.placeOf(20, 0.75);
  dragTransfer(state, pointer, at, at);
  EXPECT_EQ(state.volume.transfer->points().size(), 3U);
  state.seconds += kDoubleClickSeconds / 2;
  dragTransfer(state, pointer, at, at + glm::dvec2(50, 0));
  ASSERT_EQ(state.volume.transfer->points().size(), 4U);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 30) << "added at 20, and dragged on at once";
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].opacity, 0.75);
  dragTransfer(state, pointer, {200, 60}, {200, 60});
  state.seconds += 2 * kDoubleClickSeconds;
  dragTransfer(state, pointer, {200, 60}, {200, 60});
  EXPECT_EQ(state.volume.transfer->points().size(), 4U) << "too late for a double click";
  dragTransfer(state, pointer, {400, 60}, {400, 60});
  EXPECT_EQ(state.volume.transfer->points().size(), 4U) << "too far away for one";
}

TEST(TransferPointer, theWheelZoomsAndADragBesidePointsMovesTheValues) {
  ViewerState state = transferState();
  TransferPointer pointer;
  TransferPointer::scroll(state, transferFrameOf(state), kTransferFrame.placeOf(40, 0.5), 3);
  EXPECT_LT(state.volume.axis.width(), 60);
  EXPECT_NEAR(state.volume.axis.shareOf(40), 0.4, 1e-12);
  const ValueAxis before = state.volume.axis;
  dragTransfer(state, pointer, {200, 60}, {250, 60});
  EXPECT_NEAR(state.volume.axis.least, before.least - before.width() / 10, 1e-12) << "values follow the pointer";
  TransferPointer::scroll(state, transferFrameOf(state), kTransferFrame.placeOf(40, 0.5), -30);
  EXPECT_EQ(state.volume.axis, state.volume.values);
}

TEST(TransferPointer, aPointThatIsChangedUnderItIsLetGo) {
  ViewerState state = transferState();
  TransferPointer pointer;
  pointer.press(state, kTransferFrame, kTransferFrame.placeOf(50, 0.5));
  state.volume.transfer->removePoint(1);
  state.volume.transfer->choose(std::nullopt);
  pointer.move(state, kTransferFrame, {300, 100});
  EXPECT_EQ(state.volume.transfer->points().size(), 2U);
  EXPECT_EQ(state.volume.transfer->points()[1].value, 100);
}

PaneKeyOutcome pressTransferKey(ViewerState& state, Key key, Modifiers modifiers = {}) {
  return applyTransferKey(state, {key, true, modifiers});
}

TEST(TransferKeys, noKeyDoesTwoThings) {
  std::set<std::tuple<Key, bool, bool>> seen;
  for (const PaneKey& each : transferKeys()) {
    EXPECT_TRUE(seen.insert({each.key, each.shift, each.control}).second) << nameOf(each.key);
    EXPECT_EQ(*each.keys == '\0', *each.text == '\0');
  }
}

TEST(TransferKeys, tabGoesThroughThePointsAndOut) {
  ViewerState state = transferState();
  for (const size_t expected : {0U, 1U, 2U}) {
    EXPECT_TRUE(pressTransferKey(state, Key::kTab).used);
    EXPECT_EQ(state.volume.transfer->chosen(), expected);
  }
  EXPECT_FALSE(pressTransferKey(state, Key::kTab).used) << "on to the next pane";
  EXPECT_EQ(state.volume.transfer->chosen(), std::nullopt);
  EXPECT_TRUE(pressTransferKey(state, Key::kTab, {.shift = true}).used);
  EXPECT_EQ(state.volume.transfer->chosen(), 2U);
}

TEST(TransferKeys, arrowsMoveTheChosenPoint) {
  ViewerState state = transferState();
  EXPECT_FALSE(pressTransferKey(state, Key::kRight).used) << "none is chosen";
  state.volume.transfer->choose(1);
  pressTransferKey(state, Key::kRight);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 51);
  pressTransferKey(state, Key::kLeft, {.control = true});
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 50.9);
  pressTransferKey(state, Key::kUp);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].opacity, 0.52);
  pressTransferKey(state, Key::kDown, {.control = true});
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].opacity, 0.518);
  EXPECT_TRUE(applyAction(state, ViewerAction::kUndoTransfer));
  EXPECT_EQ(state.volume.transfer->points()[1].value, 50) << "one step";
  EXPECT_TRUE(applyAction(state, ViewerAction::kRedoTransfer));
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 50.9);
}

TEST(TransferKeys, anArrowIsOneStepUntilItIsLetGo) {
  ViewerState state = transferState();
  state.volume.transfer->choose(1);
  pressTransferKey(state, Key::kRight);
  pressTransferKey(state, Key::kRight);  // held, it repeats
  EXPECT_FALSE(applyTransferKey(state, {Key::kRight, false, {}}).used);
  pressTransferKey(state, Key::kRight);
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 53);
  EXPECT_TRUE(applyAction(state, ViewerAction::kUndoTransfer));
  EXPECT_DOUBLE_EQ(state.volume.transfer->points()[1].value, 52);
  EXPECT_TRUE(applyAction(state, ViewerAction::kUndoTransfer));
  EXPECT_EQ(state.volume.transfer->points()[1].value, 50);
}

TEST(TransferKeys, pointsAreAddedAndRemoved) {
  ViewerState state = transferState();
  state.volume.transfer->choose(1);
  pressTransferKey(state, Key::kA);
  EXPECT_EQ(state.volume.transfer->points().size(), 4U);
  EXPECT_EQ(state.volume.transfer->points()[*state.volume.transfer->chosen()].value, 75);
  for (int i = 0; i < 3; ++i) {
    EXPECT_STREQ(pressTransferKey(state, Key::kDelete).note, "");
  }
  EXPECT_STRNE(pressTransferKey(state, Key::kDelete).note, "") << "the last one stays, and that is said";
  EXPECT_EQ(state.volume.transfer->points().size(), 1U);
  EXPECT_TRUE(pressTransferKey(state, Key::kEscape).used);
  EXPECT_FALSE(pressTransferKey(state, Key::kEscape).used);
}

TEST(TransferKeys, meanWhatTheyMeanElsewhereInOtherPanes) {
  ViewerState state = transferState();
  state.active = Pane::kVolume;
  EXPECT_FALSE(pressTransferKey(state, Key::kTab).used);
  state.active = Pane::kTransfer;
  state.volume.transfer.reset();
  EXPECT_FALSE(pressTransferKey(state, Key::kTab).used) << "the volume has not come yet";
}

TEST(TransferKeys, valuesAreZoomedAroundThePoint) {
  ViewerState state = transferState();
  state.volume.transfer->choose(2);
  pressTransferKey(state, Key::kEqual);
  EXPECT_EQ(state.volume.axis, (ValueAxis{20, 100}));
  pressTransferKey(state, Key::kMinus);
  EXPECT_EQ(state.volume.axis, state.volume.values);
  applyAction(state, ViewerAction::kZoomIn);
  applyAction(state, ViewerAction::kResetView);
  EXPECT_EQ(state.volume.axis, state.volume.values);
}

}  // namespace
}  // namespace ocelli
