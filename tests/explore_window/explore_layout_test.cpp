#include "oc_core/explore_window/explore_layout.h"

#include <gtest/gtest.h>

#include "oc_core/explore_window/explore_image_fit.h"
#include "oc_core/explore_window/explore_plan_sight.h"
#include "oc_core/explore_window/explore_tints.h"

namespace ocelli {
namespace {

bool overlap(const ExplorePaneRect& a, const ExplorePaneRect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(ExploreLayout, panesCoverWhatIsBetweenTheBars) {
  const ExploreWindowLayout layout = exploreWindowLayout({0, 1, 2}, 0.34f, {1280, 720}, 1);
  ASSERT_EQ(layout.panes.size(), 3U);
  EXPECT_EQ(layout.choices, (ExplorePaneRect{0, 0, 1280, 40}));
  EXPECT_EQ(layout.status, (ExplorePaneRect{0, 690, 1280, 30}));
  EXPECT_EQ(layout.panes[0].rect, (ExplorePaneRect{0, 40, 843, 650}));  // a column of round(0.34 * 1280) and a gap of 2
  EXPECT_EQ(layout.panes[1].title, (ExplorePaneRect{845, 40, 435, 26}));
  EXPECT_EQ(layout.panes[2].rect.bottom(), 690);
  EXPECT_EQ(layout.paneAt({100, 100})->kind, 0U);
  EXPECT_EQ(layout.paneAt({1000, 600})->kind, 2U);
  EXPECT_EQ(layout.paneAt({100, 10}), nullptr);
}

TEST(ExploreLayout, theViewAloneFillsAll) {
  const ExploreWindowLayout layout = exploreWindowLayout({0}, 0, {1280, 720}, 1);
  EXPECT_EQ(layout.panes.front().rect, (ExplorePaneRect{0, 40, 1280, 650}));
}

TEST(ExploreLayout, nothingOverlapsOrIsEmptyInAnySize) {
  for (const glm::vec2 size : {glm::vec2(1, 1), glm::vec2(200, 90), glm::vec2(640, 360), glm::vec2(3840, 2160)}) {
    for (const float scale : {1.0f, 2.0f}) {
      const ExploreWindowLayout layout = exploreWindowLayout({0, 1, 2, 3}, 0.5f, size, scale);
      for (size_t i = 0; i < layout.panes.size(); ++i) {
        EXPECT_GE(layout.panes[i].rect.width, 1);
        EXPECT_GE(layout.panes[i].rect.height, 1);
        for (size_t k = i + 1; size.x > 100 && k < layout.panes.size(); ++k) {
          EXPECT_FALSE(overlap(layout.panes[i].rect, layout.panes[k].rect)) << size.x << " " << i << " " << k;
        }
      }
    }
  }
}

TEST(ExploreImageFit, keepsTheShapeAndGoesBack) {
  const ExploreImageFit fit = exploreImageFit({10, 20, 400, 400}, {200, 100});
  EXPECT_EQ(fit.onScreen({0, 0}), glm::vec2(10, 120));
  EXPECT_EQ(fit.onScreen({200, 100}), glm::vec2(410, 320));
  EXPECT_EQ(fit.inImage({210, 220}), glm::vec2(100, 50));
}

TEST(ExplorePlanSight, allOfItFitsAtAZoomOfOne) {
  const ExplorePlanSight sight = explorePlanSight({0, 0, 200, 100}, {-10, -30}, {10, 10}, {0, 0}, 1);
  EXPECT_EQ(sight.middle, glm::vec2(0, -10));
  EXPECT_FLOAT_EQ(sight.scale, 92.0f / 40);  // 92 % of the height for 40 units
  EXPECT_NEAR(glm::distance(sight.inPlan(sight.onScreen({3, 4})), glm::vec2(3, 4)), 0, 1e-5);  // rounding of floats
}

TEST(ExplorePlanSight, theWalkerIsInTheMiddleUnlessThePlanEndsThere) {
  const ExplorePaneRect rect{0, 0, 100, 100};
  EXPECT_EQ(explorePlanSight(rect, {0, 0}, {100, 100}, {40, 60}, 4).middle, glm::vec2(40, 60));
  const ExplorePlanSight edge = explorePlanSight(rect, {0, 0}, {100, 100}, {1, 99}, 4);
  EXPECT_NEAR(edge.middle.x, 12.5f, 1e-4f);  // half of a quarter
  EXPECT_NEAR(edge.middle.y, 87.5f, 1e-4f);
}

TEST(ExploreTints, onlyBendsThatANumberFitsInto) {
  const auto box = [](float width, float height, int color) {
    return WindowTint{{{10, 10}, {10 + width, 10}, {10 + width, 10 + height}}, color};
  };
  EXPECT_TRUE(showsTint(box(40, 40, 1), 1));
  EXPECT_FALSE(showsTint(box(40, 40, 0), 1));  // it does not bend
  EXPECT_FALSE(showsTint(box(40, 40, 1), 0.5f));
  EXPECT_FALSE(showsTint(box(400, 10, 1), 1));
  EXPECT_FALSE(showsTint({{{10, 10}, {60, 60}}, 1}, 1));
  EXPECT_EQ(extentOf(box(40, 30, 1)).upper, glm::vec2(50, 40));
}

TEST(ExplorePlanSight, lengthsAreRound) {
  EXPECT_FLOAT_EQ(roundExploreLength(7), 5);
  EXPECT_FLOAT_EQ(roundExploreLength(5), 5);
  EXPECT_FLOAT_EQ(roundExploreLength(49), 20);
  EXPECT_FLOAT_EQ(roundExploreLength(0.19f), 0.1f);
}

}  // namespace
}  // namespace ocelli
