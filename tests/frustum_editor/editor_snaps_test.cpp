#include "oc_core/frustum_editor/editor_snaps.h"

#include <gmock/gmock.h>

#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

TEST(EditorSnaps, theNearestPointComesBeforeTheGrid) {
  const std::vector<SnapPoint> points{{"far", {1.4, 0}}, {"near", {1.1, 0}}};
  EXPECT_EQ(snapped(points, {1, 0}, 0.5, 1)->what, "near");
  EXPECT_EQ(snapped(points, {3.1, 2}, 0.5, 1)->what, "grid");
  EXPECT_EQ(snapped(points, {3.1, 2}, 0.5, 1)->at, glm::dvec2(3, 2));
  EXPECT_FALSE(snapped(points, {3.4, 2}, 0.5, 1));  // the grid holds half as far
  EXPECT_FALSE(snapped(points, {3.1, 2}, 0.5, 0));
}

TEST(EditorSnaps, gridStepsAreRound) {
  // At least 12 pixels: 1, 2 and 5 times a power of ten.
  EXPECT_DOUBLE_EQ(gridStep(0.1), 2);
  EXPECT_DOUBLE_EQ(gridStep(0.01), 0.2);
  EXPECT_DOUBLE_EQ(gridStep(0.4), 5);
  EXPECT_DOUBLE_EQ(gridStep(1), 20);
  EXPECT_DOUBLE_EQ(gridStep(0.08), 1);
}

TEST(EditorSnaps, aSceneGivesPortalsAndTheCornersOfWalls) {
  SceneGuides guides;
  guides.portals = {{{3, 1, -2}, {0, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}}};
  const std::vector<SnapPoint> points = sceneSnaps(test::editorMesh(), guides, PlanSide::kTop, 1.5);
  const auto has = [&](const std::string& what, const glm::dvec2& at) {
    return std::any_of(points.begin(), points.end(), [&](const SnapPoint& point) {
      return point.what == what && glm::distance(point.at, at) < 1e-5;  // floats of lengths up to 10
    });
  };
  EXPECT_TRUE(has("middle of portal 1", {3, -2}));
  EXPECT_TRUE(has("side of portal 1", {2.5, -2}));
  EXPECT_TRUE(has("corner of a wall", {-10, -10}));
  EXPECT_TRUE(has("corner of a wall", {10, -10}));
}

TEST(EditorSnaps, aPlanCutsWhereWallsAre) {
  EXPECT_EQ(planCut(test::editorMesh(), PlanSide::kTop, {0, 1.5, 8}), 1.5);
  // Above all walls: a tenth of the height of 4.
  EXPECT_NEAR(planCut(test::editorMesh(), PlanSide::kTop, {0, 50, 8}), 0.4, 1e-6);
}

TEST(EditorSnaps, anEditorSnapsToPlanesOfOtherFrusta) {
  test::EditorFixture fixture;
  fixture.stroke("bend", {-6, 2}, {6, 2});
  fixture.editor.renameSelected("ahead");
  const auto ends = endsOf(fixture.frustum("ahead").begins, PlanSide::kTop);
  ASSERT_TRUE(ends);
  const glm::dvec2 end = paperFromWorld(PlanSide::kTop, (*ends)[0]);
  fixture.editor.chooseTool("limit");
  PlanPointer pointer{PlanSide::kTop, end + glm::dvec2(0.05, 0.03), 0.2, true};
  fixture.editor.press(pointer);
  ASSERT_TRUE(fixture.editor.snap());
  EXPECT_EQ(fixture.editor.snap()->what, "plane of ahead");
  EXPECT_EQ(fixture.editor.stroke()->from, end);
  // And to any point on it: the plane is at z = 2.
  fixture.editor.press({PlanSide::kTop, {1.234, 2.1}, 0.2, true});
  ASSERT_TRUE(fixture.editor.snap());
  EXPECT_EQ(fixture.editor.snap()->what, "on the plane of ahead");
  EXPECT_LT(glm::distance(fixture.editor.snap()->at, glm::dvec2(1.234, 2)), 1e-5);  // views are floats
  pointer.snaps = false;
  fixture.editor.press(pointer);
  EXPECT_FALSE(fixture.editor.snap());
  fixture.editor.cancel();
}

}  // namespace
}  // namespace ocelli
