#include "display_sim/quilt/quilt_views.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

// 400 x 400 pixels a tile, five views 10 degrees apart.
const QuiltDisplay kSquare{"square", 5, 1, 2000, 400, 1, 40};

ImagePoint seen(const PinholeCamera& camera, const glm::vec3& point) {
  return camera.project(point).value_or(ImagePoint{});
}

TEST(QuiltViews, eyesStandOnALineFromLeftToRight) {
  const QuiltViews views(kSquare, View{});  // from 10 radii away
  ASSERT_EQ(views.count(), 5);
  EXPECT_NEAR(views.camera(0).eye().x, -10 * std::tan(radiansFromDegrees(20)), 1e-5);
  EXPECT_NEAR(views.camera(1).eye().x, -10 * std::tan(radiansFromDegrees(10)), 1e-5);
  EXPECT_EQ(views.camera(2).eye(), glm::vec3(0, 0, 10));
  EXPECT_NEAR(views.camera(4).eye().x, 10 * std::tan(radiansFromDegrees(20)), 1e-5);
  for (int i = 0; i < views.count(); ++i) {
    EXPECT_EQ(views.camera(i).forward(), glm::vec3(0, 0, -1));
    EXPECT_EQ(views.camera(i).eye().z, 10);
  }
}

TEST(QuiltViews, aPointInThePlaneOfTheDisplayKeepsItsPixel) {
  const QuiltViews views(kSquare, View{});
  for (const glm::vec3& point : {glm::vec3(0), glm::vec3(0.5f, -0.25f, 0), glm::vec3(-0.9f, 0.9f, 0)}) {
    const ImagePoint first = seen(views.camera(0), point);
    for (int i = 1; i < views.count(); ++i) {
      // Coordinates of single floats near 400.
      EXPECT_NEAR(seen(views.camera(i), point).u, first.u, 1e-3);
      EXPECT_NEAR(seen(views.camera(i), point).v, first.v, 1e-3);
    }
  }
  EXPECT_NEAR(seen(views.camera(0), glm::vec3(0)).u, 200, 1e-3);
}

TEST(QuiltViews, aPointBeforeTheDisplayMovesAgainstTheEye) {
  const QuiltViews views(kSquare, View{});
  const double focal = static_cast<double>(views.camera(0).focalPixels());
  for (int i = 0; i < views.count(); ++i) {
    const double eye = 10 * std::tan(radiansFromDegrees(views.angleDegrees(i)));
    // A radius before the display, 9 from the eye: it is seen at c + f e / 10 - f e / 9.
    EXPECT_NEAR(seen(views.camera(i), {0, 0, 1}).u, 200 + focal * eye * (1 / 10.0 - 1 / 9.0), 2e-3);
    EXPECT_NEAR(seen(views.camera(i), {0, 0, 1}).v, 200, 1e-3);
  }
  EXPECT_GT(seen(views.camera(0), {0, 0, 1}).u, seen(views.camera(4), {0, 0, 1}).u);
}

TEST(QuiltViews, theUnitSphereFitsInBothDirections) {
  for (const double aspect : {0.5, 1.0, 2.0}) {
    const QuiltDisplay display{"d", 3, 1, 1200, 400, aspect, 40};
    const QuiltViews views(display, View{});
    const PinholeCamera& middle = views.camera(1);
    // The rim of the sphere as seen from 10: where rays touch it, 0.1 below the plane of the display.
    const float rim = std::sqrt(1 - 0.01f);
    glm::vec3 right(rim, 0, 0.1f);
    right.x *= static_cast<float>(views.stretch());
    const ImagePoint atRight = seen(middle, right);
    const ImagePoint atTop = seen(middle, {0, rim, 0.1f});
    EXPECT_LE(atRight.u, 400.01);
    EXPECT_GE(atTop.v, -0.01);
    EXPECT_TRUE(std::abs(atRight.u - 400) < 0.01f || std::abs(atTop.v) < 0.01f) << aspect;
  }
}

TEST(QuiltViews, pixelsThatAreNotSquareAreThoseOfAStretchedWorld) {
  // A display twice as wide as high whose tiles are square: each pixel shows twice as much from left to right.
  const QuiltDisplay display{"wide", 3, 1, 1200, 400, 2, 40};
  const QuiltViews views(display, View{});
  EXPECT_EQ(views.stretch(), 0.5);
  Mesh scene;
  scene.positions = {{0.5f, 0, 0}, {0, 0.5f, 0}};
  views.stretchScene(scene, views.stretch());
  for (int i = 0; i < views.count(); ++i) {
    const ImagePoint right = seen(views.camera(i), scene.positions[0]);
    const ImagePoint up = seen(views.camera(i), scene.positions[1]);
    EXPECT_NEAR(right.u - 200, (200 - up.v) / 2, 1e-2);
    EXPECT_NEAR(right.v, 200, 1e-3);
  }
  EXPECT_NEAR(views.camera(0).eye().x, -5 * std::tan(radiansFromDegrees(20)), 1e-5);
}

TEST(QuiltViews, aViewFromElsewhereHasItsOwnRight) {
  View view;
  view.eye = {10, 0, 0};
  const QuiltViews views(kSquare, view);
  EXPECT_GT(views.camera(0).eye().z, 3);  // the left of one that looks along -x
  EXPECT_NEAR(seen(views.camera(0), glm::vec3(0)).u, 200, 1e-3);
}

}  // namespace
}  // namespace ocelli
