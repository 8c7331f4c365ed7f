// What dragging each kind of handle does, and the numbers beside it.
#include "oc_core/frustum_editor/handle_kinds.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

constexpr double kHandleRounding = 1e-3;  // coordinates in files are rounded to 0.0001 here, directions to 1e-6

class HandleKinds : public testing::Test {
 protected:
  glm::dvec3 handleAt(const std::string& frustum, const std::string& kind, int index = 0,
                      PlanSide side = PlanSide::kTop) {
    fixture.editor.selectHandle(side, frustum, kind, index);
    return fixture.editor.selectedHandle(side)->at;
  }
  /// A frustum "ahead" that all rays bend into at z = 2.
  void bendAhead() {
    fixture.stroke("bend", {-6, 2}, {6, 2});
    fixture.editor.renameSelected("ahead");
    ASSERT_EQ(fixture.editor.message(), "");
  }
  void splitAhead() {
    fixture.stroke("split", {0, 2}, {4, 3});
    fixture.editor.select("frustum 1 left");
    fixture.editor.renameSelected("left");
    fixture.editor.select("frustum 1 right");
    fixture.editor.renameSelected("right");
    ASSERT_EQ(fixture.editor.message(), "");
  }
  void expectDone() { EXPECT_EQ(fixture.editor.message(), ""); }

  test::EditorFixture fixture;
};

TEST_F(HandleKinds, haveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const HandleKind& kind : handleKinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(&handleKind(kind.name), &kind);
  }
  EXPECT_THROW(handleKind("knob"), InputError);
}

TEST_F(HandleKinds, theEyeMoves) {
  fixture.drag("root", "eye", 0, {1, 7});
  expectDone();
  EXPECT_EQ(fixture.editor.drawn().view.eye, glm::vec3(1, 1.5f, 7));
  fixture.drag("root", "eye", 0, {1, -2}, PlanSide::kFront);  // 2 above the floor
  EXPECT_EQ(fixture.editor.drawn().view.eye, glm::vec3(1, 2, 7));
}

TEST_F(HandleKinds, theTargetHasHeadingAndPitch) {
  fixture.drag("root", "target", 0, {8, 8});
  expectDone();
  fixture.editor.selectHandle(PlanSide::kTop, "root", "target", 0);
  const std::vector<HandleNumber> numbers = fixture.editor.numbers(PlanSide::kTop);
  ASSERT_EQ(numbers.size(), 5U);
  EXPECT_EQ(numbers[3].name, "heading");
  EXPECT_NEAR(numbers[3].value, 90, kHandleRounding);
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "heading", 0));
  EXPECT_NEAR(fixture.editor.drawn().view.target.z, 0, kHandleRounding);
  EXPECT_NEAR(fixture.editor.drawn().view.target.x, 0, kHandleRounding);
}

TEST_F(HandleKinds, theBorderOfTheViewIsItsFieldOfView) {
  const glm::dvec3 border = handleAt("root", "field of view");
  EXPECT_NEAR(border.x, 8 * test::editorHalfWidth(), kHandleRounding);
  // As wide to the side as far ahead: 90 degrees across, so 2 atan 9/16 upright.
  fixture.drag("root", "field of view", 0, {8, 0});
  expectDone();
  EXPECT_NEAR(fixture.editor.drawn().view.fovVerticalDegrees, 58.72, 0.01);
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "field of view", 30));
  EXPECT_EQ(fixture.editor.drawn().view.fovVerticalDegrees, 30);
  EXPECT_FALSE(fixture.editor.typeNumber(PlanSide::kTop, "field of view", 175));
  EXPECT_THAT(fixture.editor.message(), HasSubstr("1 to 170 degrees"));
}

TEST_F(HandleKinds, aViewpointMoves) {
  bendAhead();
  fixture.drag("ahead", "viewpoint", 0, {-3, 9});
  expectDone();
  EXPECT_EQ(fixture.frustum("ahead").viewpoint, glm::dvec3(-3, 1.5, 9));
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "y", 2.25));
  EXPECT_EQ(fixture.frustum("ahead").viewpoint, glm::dvec3(-3, 2.25, 9));
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "distance", 4));
  EXPECT_NEAR(glm::distance(fixture.frustum("ahead").viewpoint, fixture.frustum("ahead").begins.middle), 4,
              kHandleRounding);
}

TEST_F(HandleKinds, anAimTurnsWithoutComingNearer) {
  bendAhead();
  const glm::dvec3 middle = fixture.frustum("ahead").begins.middle;
  fixture.drag("ahead", "aim", 0, {middle.x + 1, middle.z - 1});
  expectDone();
  const DrawnFrustum& ahead = fixture.frustum("ahead");
  EXPECT_NEAR(glm::distance(ahead.viewpoint, middle), 6, kHandleRounding);
  EXPECT_LT(glm::distance(ahead.direction, glm::normalize(glm::dvec3(1, 0, -1))), kHandleRounding);
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "heading", 350));
  EXPECT_LT(fixture.frustum("ahead").direction.x, 0);
}

TEST_F(HandleKinds, aPlaneMovesAndTurns) {
  bendAhead();
  fixture.drag("ahead", "plane", 0, {0, 0});
  expectDone();
  EXPECT_NEAR(fixture.frustum("ahead").begins.plane.height({5, 5, 0}), 0, kHandleRounding);
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "heading", 20));
  EXPECT_NEAR(fixture.frustum("ahead").begins.plane.normal.x, std::sin(20 * 3.14159265358979 / 180), kHandleRounding);
}

TEST_F(HandleKinds, anEndOfAPlaneTurnsItAboutTheOther) {
  bendAhead();
  const glm::dvec3 fixed = handleAt("ahead", "plane end", 0);
  const glm::dvec3 end = handleAt("ahead", "plane end", 1);
  fixture.drag("ahead", "plane end", 1, {end.x, end.z - 1.5});
  expectDone();
  const Plane& plane = fixture.frustum("ahead").begins.plane;
  EXPECT_NEAR(plane.height(fixed), 0, kHandleRounding);
  EXPECT_NEAR(plane.height({end.x, 0, end.z - 1.5}), 0, kHandleRounding);
}

TEST_F(HandleKinds, theEdgeOfASplitMovesBothPlanes) {
  splitAhead();
  // Each half has one end of its own: the other one is the edge.
  for (const char* name : {"left", "right"}) {
    const std::vector<FrustumHandle> handles = handlesOf(fixture.editor.drawn(), PlanSide::kTop);
    EXPECT_EQ(std::count_if(handles.begin(), handles.end(),
                            [&](const FrustumHandle& handle) {
                              return handle.kind->name == "plane end" && handle.frustum == name;
                            }),
              1);
  }
  const glm::dvec3 edge = handleAt("left", "split edge");
  EXPECT_NEAR(edge.x, 0, kHandleRounding);
  EXPECT_NEAR(edge.z, 2, kHandleRounding);
  fixture.drag("left", "split edge", 0, {1, 1});
  expectDone();
  for (const char* name : {"left", "right"}) {
    EXPECT_NEAR(fixture.frustum(name).begins.plane.height({1, 0, 1}), 0, kHandleRounding) << name;
  }
  EXPECT_THROW(fixture.editor.selectHandle(PlanSide::kTop, "right", "split edge", 0), InputError);  // it has one
}

TEST_F(HandleKinds, aBorderMovesWithThatOfTheNeighbour) {
  const double half = 6 * test::editorHalfWidth();
  fixture.stroke("add", {-half, 2}, {0, 2});
  fixture.stroke("add", {0, 2}, {half, 2});
  ASSERT_EQ(fixture.editor.message(), "");
  int border = -1;  // the one in the middle of the image
  for (const FrustumHandle& handle : handlesOf(fixture.editor.drawn(), PlanSide::kTop)) {
    if (handle.kind->name == "part border" && handle.frustum == "frustum 1" && std::abs(handle.at.x) < 0.01) {
      border = handle.index;
    }
  }
  ASSERT_GE(border, 0);
  fixture.drag("frustum 1", "part border", border, {half / 2, 2});
  expectDone();
  const auto uRange = [&](const std::string& name) {
    double low = 1;
    double high = 0;
    for (const glm::dvec2& corner : fixture.frustum(name).part) {
      low = std::min(low, corner.x);
      high = std::max(high, corner.x);
    }
    return std::pair(low, high);
  };
  EXPECT_NEAR(uRange("frustum 1").second, 0.75, kHandleRounding);
  EXPECT_NEAR(uRange("frustum 2").first, 0.75, kHandleRounding);
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kTop, "from the left", 60));
  EXPECT_NEAR(uRange("frustum 2").first, 0.6, kHandleRounding);
}

TEST_F(HandleKinds, theBorderOfTheImageIsSharedByNone) {
  const double half = 6 * test::editorHalfWidth();
  fixture.stroke("add", {-half, 2}, {0, 2});
  fixture.stroke("add", {0, 2}, {half, 2});
  // Both reach to the top of the image; that of one moves down.
  for (const FrustumHandle& handle : handlesOf(fixture.editor.drawn(), PlanSide::kFront)) {
    if (handle.kind->name == "part border" && handle.frustum == "frustum 1" &&
        fixture.frustum("frustum 1").part[static_cast<size_t>(handle.index)].y < 0.01) {
      fixture.editor.selectHandle(PlanSide::kFront, "frustum 1", "part border", handle.index);
    }
  }
  EXPECT_TRUE(fixture.editor.typeNumber(PlanSide::kFront, "from the top", 40)) << fixture.editor.message();
  const auto top = [&](const std::string& name) {
    double least = 1;
    for (const glm::dvec2& corner : fixture.frustum(name).part) {
      least = std::min(least, corner.y);
    }
    return least;
  };
  EXPECT_NEAR(top("frustum 1"), 0.4, kHandleRounding);
  EXPECT_EQ(top("frustum 2"), 0);
}

TEST_F(HandleKinds, limitsMoveAndTurn) {
  fixture.stroke("limit", {-5, -6}, {5, -6});
  fixture.stroke("limit", {-5, -4}, {5, -4});
  fixture.drag("root", "limit", 1, {0, -2});
  expectDone();
  ASSERT_EQ(fixture.frustum("root").limits.size(), 2U);
  EXPECT_NEAR(fixture.frustum("root").limits[0].plane.height({7, 7, -6}), 0, kHandleRounding);
  EXPECT_NEAR(fixture.frustum("root").limits[1].plane.height({7, 7, -2}), 0, kHandleRounding);
  const glm::dvec3 fixed = handleAt("root", "limit end", 2);
  const glm::dvec3 end = handleAt("root", "limit end", 3);
  fixture.drag("root", "limit end", 3, {end.x, end.z + 1});
  expectDone();
  EXPECT_NEAR(fixture.frustum("root").limits[1].plane.height(fixed), 0, kHandleRounding);
  EXPECT_NEAR(fixture.frustum("root").limits[1].plane.height({end.x, 0, end.z + 1}), 0, kHandleRounding);
}

TEST(TurnHandles, moveTheTransition) {
  test::CurvedEditorFixture fixture;
  fixture.stroke("turn", {7, 2}, {-7, 2});
  ASSERT_EQ(fixture.editor.message(), "");
  const glm::dvec3 middle = fixture.frustum("turn 1").begins.middle;
  fixture.drag("turn 1", "turn", 0, {middle.x, middle.z - 1});
  EXPECT_EQ(fixture.editor.message(), "");
  EXPECT_NEAR(fixture.frustum("turn 1").turnLine.z, 1, kHandleRounding);

  // The line comes nearer: the far ends stay.
  const glm::dvec3 line = fixture.frustum("turn 1").turnLine;
  fixture.drag("turn 1", "turn line", 0, {line.x + 1, line.z});
  EXPECT_EQ(fixture.editor.message(), "");
  EXPECT_NEAR(fixture.frustum("turn 1").turnLine.x, line.x + 1, kHandleRounding);

  fixture.editor.selectHandle(PlanSide::kTop, "turn 1", "turn plane", 2);
  const glm::dvec3 end = fixture.editor.selectedHandle(PlanSide::kTop)->at;
  fixture.drag("turn 1", "turn plane", 2, {end.x, end.z - 1});
  EXPECT_EQ(fixture.editor.message(), "");
  EXPECT_NEAR(fixture.frustum("turn 1").turn[2].plane.height({end.x, 0, end.z - 1}), 0, kHandleRounding);

  fixture.drag("turn 1", "viewpoint", 0, {-1, 7});
  EXPECT_EQ(fixture.editor.message(), "");
  EXPECT_FALSE(std::get<CurvedRayCamera>(fixture.editor.camera()).bends()[0].isStraight());
}

}  // namespace
}  // namespace ocelli
