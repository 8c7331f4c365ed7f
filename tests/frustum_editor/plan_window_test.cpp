#include "oc_core/frustum_editor/plan_window.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr double kWindowRounding = 1e-9;  // of pixels and lengths up to a thousand, in doubles

TEST(PlanWindow, showsAllOfABoxFromEachSide) {
  const Box box{{-4, 1, -30}, {8, 5, 2}};
  for (const PlanSide side : {PlanSide::kTop, PlanSide::kFront, PlanSide::kRight}) {
    const PlanWindow window = PlanWindow::around(side, box, {640, 400});
    for (const glm::vec3& corner : cornersOf(box)) {
      const glm::dvec2 pixel = window.pixelFromWorld(glm::dvec3(corner));
      EXPECT_TRUE(pixel.x > 0 && pixel.x < 640 && pixel.y > 0 && pixel.y < 400) << nameOf(side);
    }
  }
}

TEST(PlanWindow, goesFromPixelsToPaperAndBack) {
  const PlanWindow window{PlanSide::kTop, {3, -7}, 0.05, {200, 100}};
  EXPECT_EQ(window.pixelFromPaper({3, -7}), glm::dvec2(100, 50));
  EXPECT_EQ(window.pixelFromPaper({4, -6}), glm::dvec2(120, 70));
  const glm::dvec2 back = window.paperFromPixel(window.pixelFromPaper({12.3, 4.5}));
  EXPECT_NEAR(back.x, 12.3, kWindowRounding);
  EXPECT_NEAR(back.y, 4.5, kWindowRounding);
}

TEST(PlanWindow, paperAndWorldAgree) {
  const glm::dvec3 point(1, 2, 3);
  for (const PlanSide side : {PlanSide::kTop, PlanSide::kFront, PlanSide::kRight}) {
    EXPECT_EQ(worldFromPaper(side, paperFromWorld(side, point), point[axisOf(side)]), point);
  }
  // Seen from above the north, -z, is at the top; from the sides the sky is.
  EXPECT_LT(paperFromWorld(PlanSide::kTop, {0, 0, -1}).y, 0);
  EXPECT_LT(paperFromWorld(PlanSide::kFront, {0, 1, 0}).y, 0);
  EXPECT_LT(paperFromWorld(PlanSide::kRight, {0, 1, 0}).y, 0);
}

TEST(PlanWindow, zoomKeepsWhatIsUnderThePointer) {
  PlanWindow window{PlanSide::kTop, {3, -7}, 0.05, {200, 100}};
  const glm::dvec2 pixel(30, 80);
  const glm::dvec2 before = window.paperFromPixel(pixel);
  window.zoom(2, pixel);
  EXPECT_DOUBLE_EQ(window.unitsPerPixel, 0.025);
  EXPECT_NEAR(window.paperFromPixel(pixel).x, before.x, kWindowRounding);
  EXPECT_NEAR(window.paperFromPixel(pixel).y, before.y, kWindowRounding);
  for (int i = 0; i < 200; ++i) {
    window.zoom(2, pixel);
  }
  EXPECT_GT(window.unitsPerPixel, 0);  // it stops
}

TEST(PlanWindow, panMovesThePaper) {
  PlanWindow window{PlanSide::kTop, {3, -7}, 0.05, {200, 100}};
  const glm::dvec2 before = window.pixelFromPaper({1, 1});
  window.pan({10, -20});
  EXPECT_NEAR(window.pixelFromPaper({1, 1}).x, before.x + 10, kWindowRounding);
  EXPECT_NEAR(window.pixelFromPaper({1, 1}).y, before.y - 20, kWindowRounding);
}

}  // namespace
}  // namespace ocelli
