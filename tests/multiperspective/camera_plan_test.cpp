#include "oc_core/multiperspective/camera_plan.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

// A camera that looks at a wall: all rays end at it.
TEST(CameraPlan, raysEndAtWhatTheyMeet) {
  const CameraPlan plan = planOf(GraphCamera(test::smallCamera()), test::wall(-1, 3), {.rays = 7, .groundPixels = 0});
  ASSERT_EQ(plan.rays.size(), 7u);
  for (const CameraPlan::Ray& ray : plan.rays) {
    EXPECT_TRUE(ray.meetsSurface);
    ASSERT_FALSE(ray.pieces.empty());
    EXPECT_NEAR(ray.pieces.back().points.back().y, -1, 1e-4) << "z is down on the paper";
  }
  EXPECT_TRUE(plan.ground.empty());
  ASSERT_EQ(plan.section.size(), 2u);
}

TEST(CameraPlan, raysPassInOrderFromLeftToRight) {
  const CameraPlan plan = planOf(GraphCamera(test::smallCamera()), test::wall(-1, 3), {.rays = 9, .groundPixels = 0});
  for (size_t i = 1; i < plan.rays.size(); ++i) {
    EXPECT_GT(plan.rays[i].pieces.back().points.back().x, plan.rays[i - 1].pieces.back().points.back().x);
  }
}

// Two walls, the small one hides a part of the large one: the plan shows the rays that go past it.
TEST(CameraPlan, showsTheRayToTheFarthestSurface) {
  Mesh mesh = test::wall(-1, 3);
  test::addWall(mesh, 1, 0.3f);
  const CameraPlan plan = planOf(GraphCamera(test::smallCamera()), mesh, {.rays = 5, .groundPixels = 0});
  EXPECT_NEAR(plan.rays[2].pieces.back().points.back().y, -1, 1e-4);
}

TEST(CameraPlan, partsAreOutlined) {
  Mesh mesh = test::wall(-3, 3);
  test::addWall(mesh, 2, 0.1f);
  const CameraPlan plan = planOf(test::crossroads(), mesh, {.groundPixels = 100});
  ASSERT_EQ(plan.parts.size(), 4u);
  EXPECT_EQ(plan.parts[0].outlines.size(), 2u) << "the rays of the root go on to two frusta";
  EXPECT_EQ(plan.parts[2].outlines.size(), 1u);
  // What the right frustum holds is right of the middle.
  for (const glm::vec2& point : plan.parts[2].outlines[0]) {
    EXPECT_GT(point.x, -1e-3f);
  }
  EXPECT_EQ(plan.ground.width() > plan.ground.height() ? plan.ground.width() : plan.ground.height(), 100);
}

TEST(CameraPlan, groundLiesWhereTheSectionIs) {
  // A quarter of the plan is covered by a white square; lines around it must match its border in the image.
  Mesh mesh;
  test::addQuad(mesh, {0, -1, 0}, {1, -1, 0}, {1, -1, -1}, {0, -1, -1}, glm::vec3(0));
  test::addWall(mesh, 0, 1);
  const CameraPlan plan = planOf(GraphCamera(test::smallCamera()), mesh, {.cut = -0.5f, .groundPixels = 400});
  const auto at = [&](float x, float z) {
    const glm::vec2 share = (glm::vec2(x, z) - plan.lower) / (plan.upper - plan.lower);
    return plan.ground(static_cast<int>(share.x * static_cast<float>(plan.ground.width())),
                       static_cast<int>(share.y * static_cast<float>(plan.ground.height())));
  };
  for (const float edge : {0.02f, 0.98f}) {
    EXPECT_EQ(at(edge, -0.3f), Rgb8(0, 0, 0)) << edge;
  }
  EXPECT_EQ(at(-0.02f, -0.3f), Rgb8(255, 255, 255));
}

TEST(CameraPlan, ofACurvedRayCamera) {
  const CameraPlan plan = planOf(test::bendingTwice(), test::wall(-6, 9), {.groundPixels = 0});
  ASSERT_EQ(plan.parts.size(), 5u);
  EXPECT_EQ(plan.parts[1].name, "turn 1");
}

TEST(CameraPlan, fromAllSides) {
  for (const PlanSide side : {PlanSide::kTop, PlanSide::kFront, PlanSide::kRight}) {
    const CameraPlan plan = planOf(test::crossroads(), test::boxBeforeWall(), {.side = side, .groundPixels = 50});
    EXPECT_FALSE(plan.ground.empty());
    EXPECT_LT(plan.lower.x, plan.upper.x);
    EXPECT_LT(plan.lower.y, plan.upper.y);
  }
}

TEST(CameraPlan, refusesAnEmptyScene) {
  EXPECT_THROW(planOf(test::crossroads(), Mesh{}), InputError);
}

TEST(CameraPlan, cameraThatLooksAwayHasAFrameAllTheSame) {
  const View away{.eye = {0, 0, 10}, .target = {0, 0, 20}};
  const CameraPlan plan = planOf(GraphCamera(PinholeCamera(away, 60, 40)), test::wall(-1, 3), {.groundPixels = 50});
  EXPECT_LT(plan.lower.x, plan.upper.x);
  for (const CameraPlan::Ray& ray : plan.rays) {
    EXPECT_FALSE(ray.meetsSurface);
  }
}

}  // namespace
}  // namespace ocelli
