#include "display_sim/viewer/viewer_keys.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>
#include <tuple>

namespace ocelli {
namespace {

ViewerState keyState() {
  return viewerState("builtin:teapot", {}, cameraChoice("ddoc"), View{}, 72, 48, "test");
}

TEST(ViewerKeys, noKeyDoesTwoThings) {
  std::set<std::tuple<Key, bool, bool>> seen;
  for (const KeyBinding& binding : keyBindings()) {
    EXPECT_TRUE(seen.insert({binding.key, binding.shift, binding.control}).second) << nameOf(binding.key);
  }
}

TEST(ViewerKeys, everyActionHasAKeyAndAPlaceInTheHelp) {
  std::set<ViewerAction> bound;
  for (const KeyBinding& binding : keyBindings()) {
    bound.insert(binding.action);
    EXPECT_EQ(*binding.keys == '\0', *binding.text == '\0');
  }
  EXPECT_EQ(bound.size(), static_cast<size_t>(ViewerAction::kQuit) + 1);
}

TEST(ViewerKeys, modifiersMakeOtherKeys) {
  EXPECT_EQ(actionOf({Key::kC, true, {}}), ViewerAction::kNextCamera);
  EXPECT_EQ(actionOf({Key::kC, true, {.shift = true}}), ViewerAction::kPreviousCamera);
  EXPECT_EQ(actionOf({Key::kQ, true, {.control = true}}), ViewerAction::kQuit);
  EXPECT_FALSE(actionOf({Key::kC, true, {.alt = true}}).has_value());
  EXPECT_FALSE(actionOf({Key::kC, false, {}}).has_value());  // released
  EXPECT_FALSE(actionOf({Key::kF9, true, {}}).has_value());
}

TEST(ViewerKeys, arrowsMoveTheActivePaneAlone) {
  for (const Pane pane : kPanes) {
    ViewerState state = keyState();
    const ViewerState before = state;
    state.active = pane;
    EXPECT_TRUE(applyAction(state, ViewerAction::kTurnLeft));
    EXPECT_EQ(state.scene.view != before.scene.view, pane == Pane::kScene);
    EXPECT_EQ(!(state.reference == before.reference), pane == Pane::kReference);
    EXPECT_EQ(state.reconstruction.view != before.reconstruction.view,
              pane == Pane::kReconstruction || pane == Pane::kEffect || pane == Pane::kLenses || pane == Pane::kVolume);
    EXPECT_EQ(state.display.view != before.display.view, pane == Pane::kDisplay);
  }
}

TEST(ViewerKeys, oppositeKeysUndoEachOther) {
  using enum ViewerAction;
  for (const auto& [one, other] : {std::pair{kTurnLeft, kTurnRight}, std::pair{kTurnUp, kTurnDown},
                                   std::pair{kMoveLeft, kMoveRight}, std::pair{kZoomIn, kZoomOut}}) {
    ViewerState state = keyState();
    const View before = state.reconstruction.view;
    applyAction(state, one);
    EXPECT_GT(glm::distance(state.reconstruction.view.eye, before.eye), 0.1f);
    applyAction(state, other);
    EXPECT_LT(glm::distance(state.reconstruction.view.eye, before.eye), 1e-4f);
  }
}

TEST(ViewerKeys, tabGoesRoundAndFollowsALonePane) {
  ViewerState state = keyState();
  state.active = Pane::kDisplay;
  applyAction(state, ViewerAction::kNextPane);
  EXPECT_EQ(state.active, Pane::kScene);
  applyAction(state, ViewerAction::kMaximise2);
  EXPECT_EQ(state.maximised, Pane::kReference);
  applyAction(state, ViewerAction::kPreviousPane);
  EXPECT_EQ(state.maximised, Pane::kScene);
  applyAction(state, ViewerAction::kShowAll);
  EXPECT_FALSE(state.maximised.has_value());
}

TEST(ViewerKeys, theEffectPaneIsOnlyOnTheWayWhereItIsOn) {
  ViewerState state = keyState();
  state.active = Pane::kScene;
  applyAction(state, ViewerAction::kPreviousPane);
  EXPECT_EQ(state.active, Pane::kDisplay);
  applyAction(state, ViewerAction::kToggleEffect);
  EXPECT_TRUE(state.effect.on);
  EXPECT_EQ(state.active, Pane::kEffect);
  applyAction(state, ViewerAction::kNextPane);
  EXPECT_EQ(state.active, Pane::kScene);
  applyAction(state, ViewerAction::kMaximise5);
  EXPECT_EQ(state.maximised, Pane::kEffect);
  applyAction(state, ViewerAction::kToggleEffect);
  EXPECT_FALSE(state.effect.on);
  EXPECT_NE(state.active, Pane::kEffect);
  EXPECT_FALSE(state.maximised.has_value());
}

TEST(ViewerKeys, theEffectPaneSwitchesAndComesBack) {
  using enum EffectShown::Content;
  ViewerState state = keyState();
  applyAction(state, ViewerAction::kSwitchToTraced);
  EXPECT_EQ(state.effect.content, kByTracing);
  applyAction(state, ViewerAction::kSwitchToDifference);
  EXPECT_EQ(state.effect.content, kDifference);
  applyAction(state, ViewerAction::kSwitchToDifference);
  EXPECT_EQ(state.effect.content, kByWay);
}

TEST(ViewerKeys, escapeLeavesTheHelpFirst) {
  ViewerState state = keyState();
  applyAction(state, ViewerAction::kMaximise3);
  applyAction(state, ViewerAction::kHelp);
  applyAction(state, ViewerAction::kEscape);
  EXPECT_FALSE(state.help);
  EXPECT_TRUE(state.maximised.has_value());
  applyAction(state, ViewerAction::kEscape);
  EXPECT_FALSE(state.maximised.has_value());
}

TEST(ViewerKeys, whatNeedsMoreThanTheStateIsLeftToTheViewer) {
  using enum ViewerAction;
  for (const ViewerAction action :
       {kScreenshot, kSaveView, kSaveLenses, kSaveTransfer, kTypeTransferNumbers, kFocusPanel, kQuit}) {
    ViewerState state = keyState();
    EXPECT_FALSE(applyAction(state, action));
  }
}

TEST(ViewerKeys, contentsGoRound) {
  ViewerState state = keyState();
  std::set<std::string> shown;
  for (int i = 0; i < 5; ++i) {
    shown.emplace(nameOf(state.reconstruction.content));
    applyAction(state, ViewerAction::kNextContent);
  }
  EXPECT_EQ(shown.size(), 5U);
  EXPECT_EQ(state.reconstruction.content, ReconstructionShown::Content::kMarked);
}

}  // namespace
}  // namespace ocelli
