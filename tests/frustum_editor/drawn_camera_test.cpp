#include "oc_core/frustum_editor/drawn_camera.h"

#include <gmock/gmock.h>

#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kDrawnRounding = 1e-5;  // views are floats, of lengths up to 20

DrawnCamera drawnGraph(const GraphCamera& camera) {
  const Box world = boundsOf(test::editorMesh());
  return drawnCamera(jsonText(camera), camera, world);
}

GraphCamera::Bend bendAt(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& viewpoint) {
  return {Plane::through(point, normal), viewpoint};
}

TEST(DrawnCamera, theRootFillsWhatAPinholeSees) {
  const DrawnCamera drawn = drawnGraph(GraphCamera(test::editorRoot()));
  ASSERT_EQ(drawn.frusta.size(), 1U);
  const std::vector<glm::dvec2> outline = outlineOf(drawn.frusta[0].volumes.at(0), PlanSide::kTop);
  // At z = 0, 8 ahead, its border is 8 half widths to the side.
  const double border = 8 * test::editorHalfWidth();
  EXPECT_TRUE(isWithin(outline, {border - 0.01, 0}));
  EXPECT_FALSE(isWithin(outline, {border + 0.01, 0}));
  EXPECT_TRUE(isWithin(outline, {0, -9.99}));  // the scene ends at -10
  EXPECT_FALSE(isWithin(outline, {0, -10.01}));
  EXPECT_FALSE(isWithin(outline, {0, 8.1}));  // behind the eye
}

TEST(DrawnCamera, aPlaneEndsWhereTheRaysDo) {
  GraphCamera camera(test::editorRoot());
  camera.bend(0, bendAt({0, 0, 2}, {0, 0, -1}, {0, 1.5, 8}), "ahead");
  const DrawnCamera drawn = drawnGraph(camera);
  const auto ends = endsOf(drawn.find("ahead")->begins, PlanSide::kTop);
  ASSERT_TRUE(ends);
  const double border = 6 * test::editorHalfWidth();
  EXPECT_NEAR(std::abs((*ends)[0].x), border, kDrawnRounding);
  EXPECT_NEAR((*ends)[0].x + (*ends)[1].x, 0, kDrawnRounding);
  EXPECT_NEAR((*ends)[0].z, 2, kDrawnRounding);
  // Seen from the front, the plane is an area.
  EXPECT_FALSE(endsOf(drawn.find("ahead")->begins, PlanSide::kFront));
  EXPECT_TRUE(endsOf(drawn.find("ahead")->begins, PlanSide::kRight));
  EXPECT_NEAR(drawn.find("ahead")->direction.z, -1, kDrawnRounding);
  EXPECT_TRUE(drawn.find("root")->hasChildren);
}

TEST(DrawnCamera, aLimitEndsWhatIsFilled) {
  GraphCamera camera(test::editorRoot());
  camera.limit(0, Plane::through({0, 0, -4}, {0, 0, -1}));
  const DrawnCamera drawn = drawnGraph(camera);
  const std::vector<glm::dvec2> outline = outlineOf(drawn.frusta[0].volumes.at(0), PlanSide::kTop);
  EXPECT_TRUE(isWithin(outline, {0, -3.99}));
  EXPECT_FALSE(isWithin(outline, {0, -4.01}));
  ASSERT_EQ(drawn.frusta[0].limits.size(), 1U);
  EXPECT_NEAR(drawn.frusta[0].limits[0].middle.z, -4, kDrawnRounding);
  EXPECT_TRUE(endsOf(drawn.frusta[0].limits[0], PlanSide::kTop));
}

TEST(DrawnCamera, aMergeIsOneFrustumOfTheFileAndTwoOfTheCamera) {
  test::EditorFixture fixture;
  fixture.stroke("split", {0, 3}, {4, 4});
  ASSERT_EQ(fixture.editor.message(), "");
  fixture.stroke("merge", {-2, -1}, {2, -1});
  ASSERT_EQ(fixture.editor.message(), "");
  const DrawnFrustum* merged = fixture.editor.drawn().find("frustum 1");
  ASSERT_NE(merged, nullptr);
  EXPECT_EQ(merged->operation, "merge");
  EXPECT_EQ(merged->indices.size(), 2U);
  EXPECT_EQ(merged->depth, 2);
  EXPECT_THAT(merged->of, ElementsAre("frustum 1 left", "frustum 1 right"));
}

TEST(DrawnCamera, overlapsHaveAWitnessThatBothHold) {
  // Both halves look to the other side: their rays cross.
  GraphCamera camera(test::editorRoot());
  camera.split(0, bendAt({0, 0, 2}, {-0.3, 0, -1}, {-4, 1.5, 8}), bendAt({0, 0, 2}, {0.3, 0, -1}, {4, 1.5, 8}), "left",
               "right");
  const DrawnCamera drawn = drawnGraph(camera);
  ASSERT_EQ(drawn.overlaps.size(), 1U);
  EXPECT_EQ(drawn.overlaps[0].first, "left");
  EXPECT_EQ(drawn.overlaps[0].second, "right");
  const glm::dvec2 witness = paperFromWorld(PlanSide::kTop, drawn.overlaps[0].point);
  for (const char* name : {"left", "right"}) {
    EXPECT_TRUE(isWithin(outlineOf(drawn.find(name)->volumes.at(0), PlanSide::kTop), witness)) << name;
  }
  EXPECT_TRUE(isWithin(outlineOf(drawn.overlaps[0].volumes.at(0), PlanSide::kTop), witness));
  EXPECT_THAT(drawnGraph(GraphCamera(test::editorRoot())).overlaps, IsEmpty());
}

TEST(DrawnCamera, aPointBelongsToTheDeepestFrustum) {
  GraphCamera camera(test::editorRoot());
  camera.bend(0, bendAt({0, 0, 2}, {0, 0, -1}, {0, 1.5, 8}), "ahead");
  const DrawnCamera drawn = drawnGraph(camera);
  EXPECT_EQ(frustumAt(drawn, PlanSide::kTop, {0, 4})->name, "root");
  EXPECT_EQ(frustumAt(drawn, PlanSide::kTop, {0, 0})->name, "ahead");
  EXPECT_EQ(frustumAt(drawn, PlanSide::kTop, {-9, 7}), nullptr);
}

TEST(DrawnCamera, aTurnHasItsPlanesAndTheirLine) {
  test::CurvedEditorFixture fixture;
  fixture.stroke("turn", {7, 2}, {-7, 2});
  ASSERT_EQ(fixture.editor.message(), "");
  const DrawnFrustum& turn = fixture.frustum("turn 1");
  ASSERT_EQ(turn.turn.size(), 3U);
  EXPECT_NEAR(turn.turnLine.x, 7, kDrawnRounding);
  EXPECT_NEAR(turn.turnLine.z, 2, kDrawnRounding);
  EXPECT_NEAR(std::abs(turn.turnLineDirection.y), 1, kDrawnRounding);
  // Rays run through from, middle and to in this order.
  EXPECT_GT(turn.turn[0].middle.z, turn.turn[1].middle.z);
  EXPECT_GT(turn.turn[1].middle.z, turn.turn[2].middle.z);
  EXPECT_EQ(turn.volumes.size(), 2U);
}

}  // namespace
}  // namespace ocelli
