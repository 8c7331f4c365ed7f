// What strokes of each tool make of a camera: by hand where a number is expected.
#include "oc_core/frustum_editor/editor_tools.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kToolRounding = 1e-3;  // coordinates in files are rounded to 0.0001 here, directions to 1e-6

class EditorTools : public testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const DrawnFrustum& frustum : fixture.editor.drawn().frusta) {
      all.push_back(frustum.name);
    }
    return all;
  }
  const std::string& message() const { return fixture.editor.message(); }
  const GraphCamera& graph() const { return std::get<GraphCamera>(fixture.editor.camera()); }

  test::EditorFixture fixture;
};

TEST_F(EditorTools, areTheirNamesAndKeys) {
  std::set<std::string> names;
  std::set<char> keys;
  for (const EditorTool& tool : editorTools()) {
    EXPECT_TRUE(names.insert(tool.name).second) << tool.name;
    EXPECT_TRUE(keys.insert(tool.key).second) << tool.name;
    EXPECT_EQ(&editorTool(tool.name), &tool);
    EXPECT_TRUE(tool.ofGraph || tool.ofCurved) << tool.name;
  }
  EXPECT_EQ(editorTools().front().name, "move");
  EXPECT_THROW(editorTool("paint"), InputError);
}

TEST_F(EditorTools, bendTakesAllRaysOfAFrustum) {
  fixture.stroke("bend", {-1, 2}, {1, 2.5});
  EXPECT_EQ(message(), "");
  ASSERT_THAT(names(), ElementsAre("root", "frustum 1"));
  const DrawnFrustum& bent = fixture.frustum("frustum 1");
  EXPECT_THAT(bent.part, IsEmpty());
  EXPECT_EQ(bent.viewpoint, glm::dvec3(0, 1.5, 8));  // nothing bends before it is aimed
  EXPECT_NEAR(bent.begins.plane.height({-1, 7, 2}), 0, kToolRounding);
  EXPECT_NEAR(bent.begins.plane.height({1, -7, 2.5}), 0, kToolRounding);
  EXPECT_EQ(fixture.editor.selectedFrustum(), "frustum 1");
}

TEST_F(EditorTools, aClickBendsAcrossTheRays) {
  fixture.stroke("bend", {0, 3}, {0, 3});
  EXPECT_EQ(message(), "");
  EXPECT_LT(glm::distance(fixture.frustum("frustum 1").begins.plane.normal, glm::dvec3(0, 0, -1)), kToolRounding);
}

TEST_F(EditorTools, addTakesTheRaysThatCrossTheStroke) {
  const double half = 6 * test::editorHalfWidth();  // of the image, at z = 2
  fixture.stroke("add", {-half / 2, 2}, {half / 2, 2});
  EXPECT_EQ(message(), "");
  const GraphCamera::Part part = fixture.frustum("frustum 1").part;
  ASSERT_EQ(part.size(), 4U);
  const auto [left, right] =
      std::minmax_element(part.begin(), part.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  EXPECT_NEAR(left->x, 0.25, kToolRounding);
  EXPECT_NEAR(right->x, 0.75, kToolRounding);
}

TEST_F(EditorTools, addTakesNoRaysOfANeighbour) {
  const double half = 6 * test::editorHalfWidth();
  fixture.stroke("add", {-half, 2}, {0, 2});
  ASSERT_EQ(message(), "");
  // Drawn over all: it gets what is left.
  fixture.stroke("add", {-half * 0.6, 4}, {half * 0.99, 4});
  ASSERT_EQ(message(), "");
  for (const glm::dvec2& corner : fixture.frustum("frustum 2").part) {
    EXPECT_GE(corner.x, 0.5 - kToolRounding);
  }
  fixture.stroke("add", {-half * 0.5, 4}, {-half * 0.2, 4});
  EXPECT_THAT(message(), HasSubstr("go on to other frusta"));
  EXPECT_THAT(names(), ElementsAre("root", "frustum 1", "frustum 2"));
}

TEST_F(EditorTools, splitMeetsWhereThePressWas) {
  fixture.stroke("split", {0.5, 1}, {3, 2});
  EXPECT_EQ(message(), "");
  ASSERT_THAT(names(), ElementsAre("root", "frustum 1 left", "frustum 1 right"));
  for (const char* name : {"frustum 1 left", "frustum 1 right"}) {
    EXPECT_NEAR(fixture.frustum(name).begins.plane.height({0.5, 0, 1}), 0, kToolRounding) << name;
  }
  EXPECT_NEAR(fixture.frustum("frustum 1 right").begins.plane.height({3, 0, 2}), 0, kToolRounding);
  EXPECT_NEAR(fixture.frustum("frustum 1 left").begins.plane.height({-2, 0, 2}), 0, kToolRounding);
  EXPECT_LT(fixture.frustum("frustum 1 left").begins.middle.x, fixture.frustum("frustum 1 right").begins.middle.x);
}

TEST_F(EditorTools, aClickSplitsToo) {
  fixture.stroke("split", {0, 1}, {0, 1});
  EXPECT_EQ(message(), "");
  EXPECT_EQ(names().size(), 3U);
}

TEST_F(EditorTools, mergeGivesTwoFrustaOneViewpoint) {
  fixture.stroke("split", {0, 3}, {4, 4});
  fixture.stroke("merge", {-2, -2}, {2, -2});
  EXPECT_EQ(message(), "");
  const DrawnFrustum& merged = fixture.frustum("frustum 1");
  EXPECT_EQ(merged.viewpoint, glm::dvec3(0, 1.5, 8));  // that of the frustum that both come from
  EXPECT_NEAR(merged.begins.plane.height({2, 1.5, -2}), 0, 0.01);
  fixture.stroke("merge", {-2, 7}, {-2.1, 6.9});  // within one frustum: nothing
  EXPECT_EQ(names().size(), 4U);
}

TEST_F(EditorTools, limitEndsRays) {
  fixture.stroke("limit", {-5, -6}, {5, -6});
  EXPECT_EQ(message(), "");
  ASSERT_EQ(graph().frusta()[0].limits.size(), 1U);
  EXPECT_FALSE(graph().isBeyondLimits(0, {0, 1, -5.9}));
  EXPECT_TRUE(graph().isBeyondLimits(0, {0, 1, -6.1}));
  // A second one does not replace the first.
  fixture.stroke("limit", {1, 4}, {1, -4});
  EXPECT_EQ(graph().frusta()[0].limits.size(), 2U);
}

TEST_F(EditorTools, aimTurnsTheRoot) {
  fixture.stroke("aim", {0, 5}, {6, 8});
  EXPECT_EQ(message(), "");
  EXPECT_EQ(fixture.editor.drawn().view.target, glm::vec3(6, 1.5f, 8));
}

TEST_F(EditorTools, aimTurnsAFrustumAboutItsPlane) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  fixture.stroke("aim", {0, 0}, {2, 0});
  EXPECT_EQ(message(), "");
  // The plane's middle is at (0, 1.5, 2), 6 before the viewpoint: its rays now go towards (2, 1.5, 0).
  const glm::dvec3 expected = glm::dvec3(0, 1.5, 2) - glm::normalize(glm::dvec3(2, 0, -2)) * 6.0;
  EXPECT_LT(glm::distance(fixture.frustum("frustum 1").viewpoint, expected), 0.01);
}

TEST_F(EditorTools, deleteTakesAllThatComesFromAFrustum) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  fixture.stroke("bend", {-8, -2}, {8, -2});
  ASSERT_EQ(names().size(), 3U);
  fixture.stroke("delete", {0, 0}, {0, 0});
  EXPECT_EQ(message(), "");
  EXPECT_THAT(names(), ElementsAre("root"));
  fixture.stroke("delete", {0, 0}, {0, 0});
  EXPECT_THAT(message(), HasSubstr("the root stays"));
}

TEST_F(EditorTools, strokesOutsideOfTheRaysAreRefusedInWords) {
  fixture.stroke("bend", {-9, 8}, {-9, 7});
  EXPECT_THAT(message(), HasSubstr("no rays"));
  EXPECT_THAT(names(), ElementsAre("root"));
}

TEST_F(EditorTools, aSidePlanPartsTheImageByRows) {
  // At z = 2, 6 before the eye, the image is 12 tan 22.5 high around 1.5: from the middle of the image up.
  const double half = 6 * std::tan(22.5 * 3.14159265358979 / 180);
  fixture.stroke("add", {-2, -1.5}, {-2, -(1.5 + half)}, PlanSide::kRight);
  EXPECT_EQ(message(), "");
  const GraphCamera::Part part = fixture.frustum("frustum 1").part;
  for (const glm::dvec2& corner : part) {
    EXPECT_LE(corner.y, 0.5 + kToolRounding);
  }
  EXPECT_THAT(part, testing::Contains(testing::Field(&glm::dvec2::x, testing::DoubleNear(1, kToolRounding))));
}

TEST_F(EditorTools, toolsOfOtherCamerasAreRefused) {
  fixture.editor.chooseTool("turn");
  EXPECT_THAT(message(), HasSubstr("is for curved ray cameras"));
  EXPECT_EQ(fixture.editor.tool().name, "move");
  test::CurvedEditorFixture curved;
  curved.editor.chooseTool("split");
  EXPECT_THAT(curved.editor.message(), HasSubstr("is for graph cameras"));
}

TEST(CurvedEditorTools, turnMakesATurnAboutTheBeginningOfTheStroke) {
  test::CurvedEditorFixture fixture;
  fixture.stroke("turn", {7, 2}, {-7, 2});
  EXPECT_EQ(fixture.editor.message(), "");
  const CurvedRayCamera& camera = std::get<CurvedRayCamera>(fixture.editor.camera());
  ASSERT_EQ(camera.bends().size(), 1U);
  EXPECT_TRUE(camera.bends()[0].isStraight());  // until its viewpoint moves
  fixture.stroke("turn", {-9, -3}, {9, -3});
  EXPECT_EQ(fixture.editor.message(), "");
  EXPECT_EQ(std::get<CurvedRayCamera>(fixture.editor.camera()).bends().size(), 2U);
}

}  // namespace
}  // namespace ocelli
