#include "display_sim/viewer/lens_keys.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/viewer/lens_state.h"

namespace ocelli {
namespace {

using test::lensState;

PaneKeyOutcome press(ViewerState& state, Key key, Modifiers modifiers = {}) {
  return applyLensKey(state, {key, true, modifiers});
}
const GpcRegion& lensAt(const ViewerState& state, size_t lens) {
  return state.work.camera.gpc.regions[lens];
}

TEST(LensKeys, noKeyDoesTwoThings) {
  std::set<std::tuple<Key, bool, bool>> seen;
  for (const PaneKey& each : lensKeys()) {
    EXPECT_TRUE(seen.insert({each.key, each.shift, each.control}).second) << nameOf(each.key);
    EXPECT_EQ(*each.keys == '\0', *each.text == '\0');
  }
}

TEST(LensKeys, tabGoesThroughTheLensesAndThenOutOfThePane) {
  ViewerState state = lensState();
  EXPECT_TRUE(press(state, Key::kTab).used);
  EXPECT_EQ(state.lenses.chosen, 0U);
  EXPECT_TRUE(press(state, Key::kTab).used);
  EXPECT_EQ(state.lenses.chosen, 1U);
  EXPECT_FALSE(press(state, Key::kTab).used);
  EXPECT_EQ(state.lenses.chosen, std::nullopt);
  EXPECT_TRUE(press(state, Key::kTab, {.shift = true}).used);
  EXPECT_EQ(state.lenses.chosen, 1U);
  EXPECT_TRUE(press(state, Key::kTab, {.shift = true}).used);
  EXPECT_FALSE(press(state, Key::kTab, {.shift = true}).used);
}

TEST(LensKeys, withoutAChosenLensKeysMeanWhatTheyMeanElsewhere) {
  ViewerState state = lensState();
  const GpcLayout before = state.work.camera.gpc;
  for (const Key key : {Key::kLeft, Key::kEqual, Key::kDelete, Key::kL, Key::kComma, Key::kEscape}) {
    EXPECT_FALSE(press(state, key).used) << nameOf(key);
  }
  EXPECT_EQ(state.work.camera.gpc, before);
  state.lenses.chosen = 0;
  state.active = Pane::kScene;
  EXPECT_FALSE(press(state, Key::kLeft).used) << "in another pane, too";
}

TEST(LensKeys, keysEditTheChosenLensAlone) {
  struct Edit {
    Key key;
    Modifiers modifiers;
    GpcRegion expected;
  };
  const GpcRegion start = lensAt(lensState(), 0);
  const auto changed = [&](auto change) {
    GpcRegion lens = start;
    change(lens);
    return lens;
  };
  // Steps are 8 pixels of 640 x 360, fine ones a pixel.
  const std::vector<Edit> edits{
      {Key::kRight, {}, changed([](GpcRegion& l) { l.center.x = 0.2f + 8 / 640.0f; })},
      {Key::kUp, {}, changed([](GpcRegion& l) { l.center.y = 0.5f - 8 / 360.0f; })},
      {Key::kLeft, {.control = true}, changed([](GpcRegion& l) { l.center.x = 0.2f - 1 / 640.0f; })},
      {Key::kRight, {.shift = true}, changed([](GpcRegion& l) { l.extent.x = 0.1f + 8 / 640.0f; })},
      {Key::kDown, {.shift = true}, changed([](GpcRegion& l) { l.extent.y = 0.1f - 8 / 360.0f; })},
      {Key::kEqual, {}, changed([](GpcRegion& l) { l.zoom = 3.3f; })},
      {Key::kMinus, {}, changed([](GpcRegion& l) { l.zoom = 3 / 1.1f; })},
      {Key::kComma, {}, changed([](GpcRegion& l) { l.transitionWidth = 1 / 1.15f; })},
      // Up to the border of the image, 0.1 of its width away, there is room for more than this.
      {Key::kPeriod, {}, changed([](GpcRegion& l) { l.transitionWidth = 1.15f; })},
  };
  for (const Edit& edit : edits) {
    ViewerState state = lensState();
    state.lenses.chosen = 0;
    EXPECT_TRUE(press(state, edit.key, edit.modifiers).used);
    const GpcRegion& lens = lensAt(state, 0);
    EXPECT_NEAR(lens.center.x, edit.expected.center.x, 1e-6) << nameOf(edit.key);
    EXPECT_NEAR(lens.center.y, edit.expected.center.y, 1e-6) << nameOf(edit.key);
    EXPECT_NEAR(lens.extent.x, edit.expected.extent.x, 1e-6) << nameOf(edit.key);
    EXPECT_NEAR(lens.extent.y, edit.expected.extent.y, 1e-6) << nameOf(edit.key);
    EXPECT_NEAR(lens.zoom, edit.expected.zoom, 1e-6) << nameOf(edit.key);
    EXPECT_NEAR(lens.transitionWidth, edit.expected.transitionWidth, 1e-6) << nameOf(edit.key);
    EXPECT_EQ(lensAt(state, 1), lensAt(lensState(), 1)) << nameOf(edit.key);
    EXPECT_TRUE(state.lenses.changedAt.has_value());
  }
}

TEST(LensKeys, aLockedLensStaysAsItIsAndSaysWhy) {
  ViewerState state = lensState();
  state.lenses.chosen = 0;
  EXPECT_TRUE(press(state, Key::kL).used);
  EXPECT_TRUE(isLocked(state, 0));
  for (const Key key : {Key::kRight, Key::kEqual, Key::kPeriod, Key::kDelete}) {
    const PaneKeyOutcome outcome = press(state, key);
    EXPECT_TRUE(outcome.used);
    EXPECT_NE(std::string(outcome.note), "");
  }
  EXPECT_EQ(state.work.camera.gpc, lensState().work.camera.gpc);
  press(state, Key::kL);
  EXPECT_TRUE(press(state, Key::kRight).used);
  EXPECT_FALSE(state.work.camera.gpc == lensState().work.camera.gpc);
}

TEST(LensKeys, lensesAreAddedAndRemovedAndKeepTheirLocks) {
  ViewerState state = lensState();
  state.lenses.chosen = 1;
  press(state, Key::kL);
  press(state, Key::kEscape);
  EXPECT_EQ(state.lenses.chosen, std::nullopt);
  EXPECT_TRUE(press(state, Key::kA).used);
  ASSERT_EQ(state.work.camera.gpc.regions.size(), 3U);
  EXPECT_EQ(state.lenses.chosen, 2U);
  state.lenses.chosen = 0;
  press(state, Key::kDelete);
  ASSERT_EQ(state.work.camera.gpc.regions.size(), 2U);
  EXPECT_EQ(lensAt(state, 0), lensAt(lensState(), 1));
  EXPECT_TRUE(isLocked(state, 0)) << "the second one is the first one now";
  EXPECT_FALSE(isLocked(state, 1));
}

TEST(LensKeys, aFullImageTakesNoMoreLenses) {
  ViewerState state = lensState();
  state.work.camera.gpc = GpcLayout{};  // one lens, whose transition reaches to the borders
  const PaneKeyOutcome outcome = press(state, Key::kInsert);
  EXPECT_TRUE(outcome.used);
  EXPECT_NE(std::string(outcome.note), "");
  EXPECT_EQ(state.work.camera.gpc, GpcLayout{});
}

TEST(LensChoice, theOtherPanesFollowOnceTheLensesRest) {
  ViewerState state = lensState();
  const uint64_t before = state.work.cameraRevision;
  state.lenses.chosen = 0;
  press(state, Key::kRight);
  followLenses(state, false);
  EXPECT_EQ(state.work.cameraRevision, before);
  state.seconds += kLensRestSeconds / 2;
  press(state, Key::kRight);
  state.seconds += kLensRestSeconds / 2;
  followLenses(state, false);
  EXPECT_EQ(state.work.cameraRevision, before) << "it was moved again";
  state.seconds += kLensRestSeconds;
  followLenses(state, false);
  EXPECT_GT(state.work.cameraRevision, before);
  const uint64_t followed = state.work.cameraRevision;
  followLenses(state, true);
  EXPECT_EQ(state.work.cameraRevision, followed) << "once";
}

TEST(LensChoice, anotherCameraForgetsTheLensesAndClosesTheirPane) {
  ViewerState state = lensState();
  state.lenses.chosen = 1;
  lockLens(state, 1, true);
  state.maximised = Pane::kLenses;
  chooseCamera(state, "ddoc");
  EXPECT_FALSE(isOffered(state, Pane::kLenses));
  EXPECT_NE(state.active, Pane::kLenses);
  EXPECT_EQ(state.maximised, std::nullopt);
  openLensPane(state);
  EXPECT_EQ(state.work.camera.name, "gpc");
  EXPECT_EQ(state.lenses.chosen, std::nullopt);
  EXPECT_FALSE(isLocked(state, 1));
}

}  // namespace
}  // namespace ocelli
