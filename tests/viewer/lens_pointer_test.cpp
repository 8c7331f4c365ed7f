#include "display_sim/viewer/lens_pointer.h"

#include <gtest/gtest.h>

#include "tests/viewer/lens_state.h"

namespace ocelli {
namespace {

using test::lensState;

/// A picture of 640 x 360 at (100, 50) of the window.
constexpr LensPointer::Frame kFrame{{100, 50}, {640, 360}, 1};

glm::dvec2 windowAt(double shareX, double shareY) {
  return kFrame.corner + glm::dvec2(shareX, shareY) * kFrame.size;
}

TEST(LensPointer, dragsALens) {
  ViewerState state = lensState();
  LensPointer pointer;
  EXPECT_TRUE(pointer.press(state, kFrame, windowAt(0.21, 0.5)));
  EXPECT_EQ(state.lenses.chosen, 0U);
  EXPECT_TRUE(pointer.move(state, kFrame, windowAt(0.41, 0.4)));
  EXPECT_NEAR(state.work.camera.gpc.regions[0].center.x, 0.4, 1e-6);
  EXPECT_NEAR(state.work.camera.gpc.regions[0].center.y, 0.4, 1e-6);
  // Into its neighbour, beside which it stays, and out of the window.
  EXPECT_TRUE(pointer.move(state, kFrame, windowAt(0.56, 0.5)));
  EXPECT_NEAR(state.work.camera.gpc.regions[0].center.x, 0.5, 1e-6);
  EXPECT_TRUE(pointer.move(state, kFrame, {-1000, 200}));
  EXPECT_NEAR(state.work.camera.gpc.regions[0].center.x, 0.1, 1e-6);
  EXPECT_STREQ(pointer.release(state, kFrame), "");
  EXPECT_FALSE(pointer.move(state, kFrame, windowAt(0.3, 0.3)));
  EXPECT_NEAR(state.work.camera.gpc.regions[0].center.x, 0.1, 1e-6);
  EXPECT_EQ(state.work.camera.gpc.regions.size(), 2U);
}

TEST(LensPointer, dragsCornersAndTheEdgeOfTheTransition) {
  ViewerState state = lensState();
  LensPointer pointer;
  EXPECT_TRUE(pointer.press(state, kFrame, windowAt(0.25, 0.55)));
  pointer.move(state, kFrame, windowAt(0.28, 0.6));
  pointer.release(state, kFrame);
  EXPECT_NEAR(state.work.camera.gpc.regions[0].extent.x, 0.13, 1e-6);
  EXPECT_NEAR(state.work.camera.gpc.regions[0].extent.y, 0.15, 1e-6);
  EXPECT_TRUE(pointer.press(state, kFrame, windowAt(0.6, 0.5)));
  pointer.move(state, kFrame, windowAt(0.575, 0.5));  // a half of half of its extent
  pointer.release(state, kFrame);
  EXPECT_NEAR(state.work.camera.gpc.regions[1].transitionWidth, 1.5, 1e-6);
}

TEST(LensPointer, aClickBesideAddsALensAndADragDoesNot) {
  ViewerState state = lensState();
  LensPointer pointer;
  EXPECT_FALSE(pointer.press(state, kFrame, windowAt(0.45, 0.2)));
  EXPECT_TRUE(pointer.move(state, kFrame, windowAt(0.45, 0.2) + glm::dvec2(2, 1))) << "a hand trembles";
  EXPECT_STREQ(pointer.release(state, kFrame), "");
  ASSERT_EQ(state.work.camera.gpc.regions.size(), 3U);
  EXPECT_EQ(state.lenses.chosen, 2U);
  const LensBox inner = lensInnerBox(state.work.camera.gpc.regions[2]);
  EXPECT_TRUE(inner.lower.x <= 0.45 && inner.upper.x >= 0.45 && inner.lower.y <= 0.2 && inner.upper.y >= 0.2);
  EXPECT_FALSE(pointer.press(state, kFrame, windowAt(0.9, 0.9)));
  EXPECT_FALSE(pointer.move(state, kFrame, windowAt(0.8, 0.8))) << "it turns the view";
  pointer.release(state, kFrame);
  EXPECT_EQ(state.work.camera.gpc.regions.size(), 3U);
  EXPECT_FALSE(pointer.press(state, kFrame, {20, 20})) << "beside the picture";
  pointer.release(state, kFrame);
  EXPECT_EQ(state.work.camera.gpc.regions.size(), 3U);
}

TEST(LensPointer, aLockedLensIsChosenButStays) {
  ViewerState state = lensState();
  lockLens(state, 0, true);
  LensPointer pointer;
  EXPECT_TRUE(pointer.press(state, kFrame, windowAt(0.2, 0.5)));
  EXPECT_TRUE(pointer.move(state, kFrame, windowAt(0.4, 0.4)));
  EXPECT_TRUE(LensPointer::scroll(state, kFrame, windowAt(0.2, 0.5), 1));
  EXPECT_EQ(state.lenses.chosen, 0U);
  EXPECT_EQ(state.work.camera.gpc, lensState().work.camera.gpc);
}

TEST(LensPointer, theWheelZoomsTheLensUnderThePointer) {
  ViewerState state = lensState();
  EXPECT_TRUE(LensPointer::scroll(state, kFrame, windowAt(0.7, 0.5), 2));
  EXPECT_NEAR(state.work.camera.gpc.regions[1].zoom, 4 * 1.15 * 1.15, 1e-5);
  EXPECT_EQ(state.work.camera.gpc.regions[0].zoom, 3);
  EXPECT_FALSE(LensPointer::scroll(state, kFrame, windowAt(0.45, 0.2), 2));
}

TEST(LensPointer, aDragEndsWhereSomethingElseChangesTheLenses) {
  ViewerState state = lensState();
  LensPointer pointer;
  pointer.press(state, kFrame, windowAt(0.2, 0.5));
  removeLensOf(state, 0);
  EXPECT_FALSE(pointer.move(state, kFrame, windowAt(0.4, 0.4)));
  EXPECT_EQ(state.work.camera.gpc.regions.size(), 1U);
}

}  // namespace
}  // namespace ocelli
