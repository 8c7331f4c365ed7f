#include "display_sim/viewer/viewer_state.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

ViewerState stateOf(const std::string& camera = "ddoc") {
  return viewerState("builtin:teapot", {}, cameraChoice(camera), View{}, 72, 48, "test");
}

TEST(ViewerState, theEyeStartsAtAnEdgeOfTheCell) {
  const ViewerState state = stateOf();
  EXPECT_NEAR(glm::distance(state.reconstruction.view.eye, View{}.eye), 0.8f * std::sqrt(2.0f), 1e-5f);
  EXPECT_EQ(state.reconstruction.view.target, View{}.target);
}

TEST(ViewerState, everyChangeOfWorkHasARevisionOfItsOwn) {
  ViewerState state = stateOf();
  std::set<uint64_t> seen{state.work.lastRevision};
  const auto expectFresh = [&](uint64_t revision) { EXPECT_TRUE(seen.insert(revision).second) << revision; };
  openScene(state, "builtin:fence");
  expectFresh(state.work.sceneRevision);
  chooseCamera(state, "eoc-h");
  expectFresh(state.work.cameraRevision);
  chooseCellSide(state, 0.5);
  expectFresh(state.work.cameraRevision);
  chooseImageSize(state, 100, 50);
  expectFresh(state.work.cameraRevision);
  moveReferenceToEye(state);
  expectFresh(state.work.cameraRevision);
  chooseReference(state, View{});
  expectFresh(state.work.cameraRevision);
  chooseProfile(state, "vortex");
  expectFresh(state.work.displayRevision);
  // One that is taken back does not give its number away again: the next request is another one.
  const uint64_t last = state.work.sceneRevision;
  openScene(state, "broken");
  state.work.sceneRevision = last;
  openScene(state, "builtin:doors");
  expectFresh(state.work.sceneRevision);
}

TEST(ViewerState, theWidthOfPointsIsThatOfOneScene) {
  SceneOptions options;
  options.points.width = 0.25;
  options.textures = false;
  ViewerState state = viewerState("points.xyz", options, cameraChoice("ddoc"), View{}, 72, 48, "test");
  openScene(state, "points.xyz");
  EXPECT_EQ(state.work.sceneOptions.points.width, 0.25) << "the same scene again";
  openScene(state, "builtin:fence");
  EXPECT_FALSE(state.work.sceneOptions.points.width);
  EXPECT_FALSE(state.work.sceneOptions.textures) << "said of every scene";
}

TEST(ViewerState, aCameraKeepsTheCell) {
  ViewerState state = stateOf();
  chooseCellSide(state, 0.4);
  chooseCamera(state, "cell");
  EXPECT_FLOAT_EQ(state.work.camera.cell.cell.sideRadii, 0.4f);
  chooseCamera(state, "eoc-v");
  EXPECT_FLOAT_EQ(state.work.camera.cellSideRadii, 0.4f);
}

TEST(ViewerState, cellsAndSizesStayWithinTheirLimits) {
  ViewerState state = stateOf();
  chooseCellSide(state, 1e9);
  EXPECT_FLOAT_EQ(state.work.camera.cellSideRadii, static_cast<float>(kMaxCellSide));
  chooseCellSide(state, -1);
  EXPECT_FLOAT_EQ(state.work.camera.cellSideRadii, static_cast<float>(kMinCellSide));
  chooseImageSize(state, -3, 1 << 30);
  EXPECT_EQ(state.work.width, kMinImageSide);
  EXPECT_EQ(state.work.height, kMaxImageSide);
}

TEST(ViewerState, anUnknownNameChangesNothing) {
  ViewerState state = stateOf();
  EXPECT_THROW(chooseCamera(state, "no-such-camera"), InputError);
  EXPECT_THROW(chooseProfile(state, "no-such-display"), InputError);
  EXPECT_EQ(state.work.camera.name, "ddoc");
  EXPECT_EQ(state.work.profile, "test");
  EXPECT_EQ(state.work.lastRevision, stateOf().work.lastRevision);
}

TEST(ViewerState, goingThroughTheCamerasMeetsAllThatHaveImages) {
  ViewerState state = stateOf("di");
  std::set<std::string> met;
  do {
    met.insert(state.work.camera.name);
    EXPECT_TRUE(state.work.camera.hasImages());
    chooseNextCamera(state, 1);
  } while (state.work.camera.name != "di");
  EXPECT_EQ(met.count("cell") + met.count("ddoc") + met.count("eoc-hv+ddoc"), 3U);
  EXPECT_EQ(met.count("simplified"), 0U);
  chooseNextCamera(state, -1);
  EXPECT_EQ(state.work.camera.name, "cylinder") << "the last that has images";
}

TEST(ViewerState, everyPaneComesBackToItsStart) {
  const ViewerState start = stateOf();
  ViewerState state = start;
  for (const Pane pane : kPanes) {
    orbitPane(state, pane, 0.3, 0.2);
    panPane(state, pane, 0.1, 0.1);
    zoomPane(state, pane, 3);
  }
  EXPECT_NE(state.scene.view, start.scene.view);
  EXPECT_FALSE(state.reference == start.reference);
  EXPECT_NE(state.reconstruction.view, start.reconstruction.view);
  EXPECT_NE(state.display.view, start.display.view);
  for (const Pane pane : kPanes) {
    resetPane(state, pane);
  }
  EXPECT_EQ(state.scene.view, start.scene.view);
  EXPECT_TRUE(state.reference == start.reference);
  EXPECT_EQ(state.reconstruction.view, start.work.reference);
  EXPECT_EQ(state.display.view, start.display.view);
}

TEST(ViewerState, aLinkedObserverIsTheEye) {
  ViewerState state = stateOf();
  state.display.followsEye = true;
  const View before = state.reconstruction.view;
  orbitPane(state, Pane::kDisplay, 0.5, 0);
  EXPECT_NE(state.reconstruction.view, before);
  EXPECT_EQ(displayView(state), state.reconstruction.view);
}

TEST(ViewerState, theScreenTurnsAsFastAsItIsTold) {
  ViewerState state = stateOf();
  advance(state, 1.0 / 48, 720);  // 12 turns a second: a quarter turn
  EXPECT_NEAR(state.display.sweepDegrees, 90, 1e-9);
  changeSpeed(state, 1.0 / 64);
  advance(state, 1.0 / 12, 720);  // a turn at full speed
  EXPECT_NEAR(state.display.sweepDegrees, 90 + 360.0 / 64, 1e-9);
  state.display.running = false;
  advance(state, 100, 720);
  EXPECT_NEAR(state.display.sweepDegrees, 90 + 360.0 / 64, 1e-9);
  EXPECT_NEAR(state.seconds, 100 + 1.0 / 12 + 1.0 / 48, 1e-9);
}

TEST(ViewerState, speedStaysWithinItsLimits) {
  ViewerState state = stateOf();
  changeSpeed(state, 1e-30);
  EXPECT_EQ(state.display.speed, kMinSpeed);
  changeSpeed(state, 1e30);
  EXPECT_EQ(state.display.speed, kMaxSpeed);
}

TEST(ViewerState, stepsGoFromSliceToSliceRoundTheTurn) {
  ViewerState state = stateOf();  // 24 slices a half turn: 7.5 degrees each
  state.display.sweepDegrees = 8;
  stepDisplay(state, 1);
  EXPECT_FALSE(state.display.running);
  EXPECT_NEAR(state.display.sweepDegrees, 15, 1e-9);
  stepDisplay(state, -3);
  EXPECT_NEAR(state.display.sweepDegrees, 352.5, 1e-9);
}

TEST(ViewerState, blinkingChangesEveryHalfSecond) {
  ViewerState state = stateOf();
  EXPECT_FALSE(blinkShowsTruth(state));
  advance(state, 0.6, 720);
  EXPECT_TRUE(blinkShowsTruth(state));
  advance(state, 0.5, 720);
  EXPECT_FALSE(blinkShowsTruth(state));
}

}  // namespace
}  // namespace ocelli
