#include "display_sim/viewer/viewer_layout.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

ViewerState layoutState() {
  return viewerState("builtin:teapot", {}, cameraChoice("di"), View{}, 72, 48, "test");
}

bool overlap(const WindowRect& a, const WindowRect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::vector<WindowRect> allRects(const ViewerLayout& layout) {
  std::vector<WindowRect> rects{layout.panel, layout.status};
  for (const PaneLayout& pane : layout.panes) {
    rects.push_back(pane.header);
    rects.push_back(pane.image);
  }
  return rects;
}

TEST(ViewerLayout, nothingOverlapsOrLeavesTheWindow) {
  for (const glm::vec2 size : {glm::vec2(1280, 800), glm::vec2(2560, 1600), glm::vec2(641, 403)}) {
    for (const float scale : {1.0f, 1.5f, 2.0f}) {
      ViewerState state = layoutState();
      for (const bool panel : {true, false}) {
        state.panel = panel;
        state.effect.on = panel;
        for (const auto maximised : {std::optional<Pane>(), std::optional(Pane::kDisplay)}) {
          state.maximised = maximised;
          const ViewerLayout layout = viewerLayout(state, size, scale);
          const std::vector<WindowRect> rects = allRects(layout);
          for (size_t i = 0; i < rects.size(); ++i) {
            EXPECT_GE(rects[i].x, 0);
            EXPECT_LE(rects[i].right(), size.x);
            EXPECT_LE(rects[i].bottom(), size.y);
            for (size_t k = 0; k < i; ++k) {
              EXPECT_FALSE(overlap(rects[i], rects[k])) << i << " and " << k;
            }
          }
        }
      }
    }
  }
}

TEST(ViewerLayout, panesAreFoundByTheirPlace) {
  ViewerState state = layoutState();
  EXPECT_EQ(viewerLayout(state, {1280, 800}, 1).panes.size(), 4U);
  state.effect.on = true;
  EXPECT_EQ(viewerLayout(state, {1280, 800}, 1).panes.size(), 5U);
  chooseCamera(state, "gpc");
  EXPECT_EQ(viewerLayout(state, {1280, 800}, 1).panes.size(), 6U);
  state.volume.on = true;  // with a surface
  state.work.sceneOptions.iso = 1;
  const ViewerLayout layout = viewerLayout(state, {1280, 800}, 1);
  ASSERT_EQ(layout.panes.size(), kPaneCount);
  for (const Pane pane : kPanes) {
    const WindowRect& image = layout.find(pane)->image;
    EXPECT_EQ(layout.paneAt({image.x + image.width / 2, image.y + image.height / 2})->pane, pane);
  }
  EXPECT_EQ(layout.paneAt({10, 10}), nullptr);  // the panel
}

TEST(ViewerLayout, aMaximisedPaneIsAlone) {
  ViewerState state = layoutState();
  state.maximised = Pane::kReference;
  const ViewerLayout layout = viewerLayout(state, {1280, 800}, 1);
  ASSERT_EQ(layout.panes.size(), 1U);
  EXPECT_EQ(layout.find(Pane::kScene), nullptr);
  EXPECT_GT(layout.panes[0].image.width, 900);
}

TEST(ViewerLayout, aTransferFunctionLiesBelowItsVolume) {
  const ViewerState state =
      viewerState("builtin:volume,name=marschner-lobb", {}, cameraChoice("di"), View{}, 72, 48, "test");
  for (const auto maximised : {std::optional<Pane>(), std::optional(Pane::kVolume)}) {
    ViewerState shown = state;
    shown.maximised = maximised;
    const ViewerLayout layout = viewerLayout(shown, {1280, 800}, 1);
    ASSERT_EQ(layout.panes.size(), maximised ? 2U : 3U);
    const PaneLayout& volume = *layout.find(Pane::kVolume);
    const PaneLayout& transfer = *layout.find(Pane::kTransfer);
    EXPECT_GT(volume.image.height, 1.5f * transfer.image.height);
    EXPECT_GT(transfer.header.y, volume.image.bottom());
    if (const PaneLayout* display = layout.find(Pane::kDisplay)) {
      EXPECT_GT(display->image.x, volume.image.right()) << "beside the volume";
      EXPECT_EQ(display->image.height, volume.image.height);
      EXPECT_EQ(transfer.image.right(), display->image.right());
    }
  }
  ViewerState alone = state;
  alone.maximised = Pane::kTransfer;
  ASSERT_EQ(viewerLayout(alone, {1280, 800}, 1).panes.size(), 1U);
  EXPECT_EQ(viewerLayout(alone, {1280, 800}, 1).panes[0].pane, Pane::kTransfer);
}

TEST(ViewerLayout, aWindowWithoutAnySizeHasOne) {
  for (const PaneLayout& pane : viewerLayout(layoutState(), {0, 0}, 3).panes) {
    EXPECT_GE(pane.image.height, 1);
  }
}

}  // namespace
}  // namespace ocelli
