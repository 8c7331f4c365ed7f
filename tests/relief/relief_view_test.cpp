#include "oc_core/relief/relief_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/ocri/spoc_builder.h"
#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

TEST(ReliefView, imagesHaveTheProportionsOfTheObject) {
  EXPECT_EQ(imageSizeFor(1, 1, 512 * 512), glm::ivec2(512, 512));
  EXPECT_EQ(imageSizeFor(4, 1, 10'000), glm::ivec2(200, 50));
  EXPECT_EQ(imageSizeFor(0, 0, 100), glm::ivec2(10, 10));
  EXPECT_EQ(imageSizeFor(3, 2, 1), glm::ivec2(1, 1));
  const Box flat = boundsOf(test::redBox({0.9f, 0.2f, 0.3f}));
  for (const bool forCell : {false, true}) {
    const ReliefViews views = reliefViews(flat, 40'000, forCell);
    EXPECT_LE(views.size.x * views.size.y, 40'000);
    EXPECT_GT(views.size.x * views.size.y, 39'000);
    EXPECT_GT(views.size.x, views.size.y);
    const PinholeCamera camera(views.reference, views.size.x, views.size.y);
    for (const glm::vec3& corner : cornersOf(flat)) {
      const auto q = camera.project(corner);
      ASSERT_TRUE(q);
      EXPECT_GT(q->u, 0);
      EXPECT_LT(q->u, static_cast<float>(views.size.x));
      EXPECT_GT(q->v, 0);
      EXPECT_LT(q->v, static_cast<float>(views.size.y));
    }
  }
}

// The lowest corners of the cell look at the tile from 10 degrees.
TEST(ReliefView, theCellReachesDownToTenDegrees) {
  const ReliefViews views = reliefViews(boundsOf(test::redBox()), 1000, true);
  double lowest = 90;
  for (const View& view : views.cell.edgeViews(views.reference)) {
    lowest = std::min(lowest, degreesFromRadians(std::asin(static_cast<double>(view.eye.y / glm::length(view.eye)))));
  }
  EXPECT_NEAR(lowest, 10, 0.1);
}

// Of a box, a pinhole above sees the top alone; the single pole camera all four sides down to the ground, as densely.
TEST(ReliefView, theSinglePoleCameraSeesTheSides) {
  const Mesh box = test::redBox({0.5f, 0.25f, 0.5f});
  const SpocCamera camera = reliefSpoc(boundsOf(box), 40'000);
  const ReferenceImage image = buildSpocImage(camera, box);
  const PinholeCamera reference = image.reference();
  size_t top = 0;
  size_t sides = 0;
  float lowest = 1;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (const auto point = image.pointOf(x, y, reference)) {
        (point->y > 0.249f ? top : sides) += 1;
        lowest = std::min(lowest, point->y);
      }
    }
  }
  EXPECT_LT(lowest, -0.23f);
  // Four sides of 1 x 0.5 to a top of 1 x 1; samples are as dense within a factor of two.
  EXPECT_GT(sides, top);
  EXPECT_LT(sides, 4 * top);
}

}  // namespace
}  // namespace ocelli
