#include "oc_core/ocri/wide_depth_image.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/coverage.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

TEST(WideFactor, anEmptyCellOrSceneNeedsNoMore) {
  EXPECT_NEAR(wideFactor(smallCamera(), test::wall(0), ViewCell{1e-6f}), 1, 1e-5f);
  EXPECT_EQ(wideFactor(smallCamera(), {}, ViewCell{}), 1);
}

TEST(WideFactor, aSceneWithinTheReferenceFrustumNeedsNoMore) {
  EXPECT_EQ(wideFactor(smallCamera(), makeBox(glm::vec3(0.5f)), ViewCell{}), 1);
}

// A wall larger than all frusta, for cells of several sizes: no viewpoint sees anything beside the wide image, and the
// one that sees farthest out comes close to its border.
TEST(WideFactor, holdsWhatTheCellSeesAndNotMuchMore) {
  const PinholeCamera reference = smallCamera();
  float before = 1;
  for (const float side : {0.4f, 1.6f, 4.0f}) {
    const Mesh scene = test::wall(0.5f, 30);
    const ViewCell cell{side};
    const float factor = wideFactor(reference, scene, cell);
    EXPECT_GT(factor, before) << "larger cells see more";
    before = factor;
    float widest = 0;
    std::vector<View> views = cell.edgeViews(View{});
    const std::vector<View> inside = cell.interiorViews(View{}, 20, 3);
    views.insert(views.end(), inside.begin(), inside.end());
    for (const View& view : views) {
      for (const glm::vec4& p : positionImage(PinholeCamera(view, kWidth, kHeight), scene)) {
        ASSERT_GT(p.w, 0);
        const auto q = reference.project(glm::vec3(p));
        ASSERT_TRUE(q);
        widest = std::max({widest, std::abs(q->u - kWidth / 2.0f) / (kWidth / 2.0f),
                           std::abs(q->v - kHeight / 2.0f) / (kHeight / 2.0f)});
      }
    }
    EXPECT_LE(widest, factor);
    // The outermost pixel centre lies half a pixel inside the frustum: 1 / 60 of the half height, and more of it where
    // it is seen from nearer by.
    EXPECT_GE(widest, factor - 1.5f / 60);
  }
}

// One tile above and behind the reference frustum, which ends at y = 11 tan(asin(0.1)) = 1.106 there; viewpoints below
// look up past the target and see it. Its upper edge is the farthest out: y / depth over the tangent of half the view.
TEST(WideFactor, isThePlaceOfWhatLiesBeside) {
  Mesh scene = test::wall(0, 0.2f);
  test::addQuad(scene, {-0.1f, 1.15f, -1}, {0.1f, 1.15f, -1}, {0.1f, 1.18f, -1}, {-0.1f, 1.18f, -1});
  EXPECT_NEAR(wideFactor(smallCamera(), scene, ViewCell{1.6f}), 1.18 / 11 / std::tan(std::asin(0.1)), 1e-5);
  EXPECT_EQ(wideFactor(smallCamera(), scene, ViewCell{0.01f}), 1) << "too small a cell to see it";
}

TEST(WideFactor, refusesACellInTheScene) {
  // Viewpoints behind the reference eye see a wall through that eye.
  EXPECT_THROW(wideFactor(smallCamera(), test::wall(10), ViewCell{1.6f}), InputError);
}

TEST(WideDepthImage, itsMiddleIsTheDepthImage) {
  const Mesh scene = test::ballBeforePlane();
  View sheared;
  sheared.centerShift = {0.2f, -0.1f};
  for (const View& view : {View{}, sheared}) {
    const PinholeCamera camera(view, kWidth, kHeight);
    const ReferenceImage image = buildDepthImage(camera, scene);
    const ReferenceImage wide = buildWideDepthImage(camera, scene, 1.3f);
    // 90 and 60 pixels times 1.3, in whole pixels on each side.
    ASSERT_EQ(wide.width(), 118);
    ASSERT_EQ(wide.height(), 78);
    EXPECT_EQ(wide.camera, "di-wide");
    EXPECT_NEAR(wide.reference().focalPixels(), camera.focalPixels(), 1e-4f);
    size_t differ = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        differ += std::abs(wide.t(x + 14, y + 9) - image.t(x, y)) > 1e-3f;
      }
    }
    // Rounding of the focal length may move a vertex across the grid that triangles are snapped to.
    EXPECT_LE(differ, 4u);
    EXPECT_EQ(wide.sampleCount(), wide.t.size()) << "the plane goes on beside the reference view";
  }
}

TEST(WideDepthImage, factorOneIsTheDepthImage) {
  const Mesh scene = test::boxBeforeWall();
  const ReferenceImage wide = buildWideDepthImage(smallCamera(), scene, 1);
  EXPECT_EQ(wide.width(), kWidth);
  EXPECT_EQ(wide.height(), kHeight);
  EXPECT_EQ(wide.sampleCount(), buildDepthImage(smallCamera(), scene).sampleCount());
}

TEST(WideDepthImage, refusesOtherFactors) {
  for (const float factor : {0.5f, 0.0f, -2.0f, std::nanf(""), 1e9f, 20000.0f}) {
    EXPECT_THROW(buildWideDepthImage(smallCamera(), test::wall(0), factor), InputError) << factor;
  }
}

}  // namespace
}  // namespace ocelli
