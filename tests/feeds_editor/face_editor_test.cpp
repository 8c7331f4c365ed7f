#include "oc_core/feeds_editor/face_editor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/feeds/made_setup.h"

namespace ocelli::test {
namespace {

constexpr double kReach = 0.3;

void drag(FaceEditor& editor, const glm::dvec2& from, const glm::dvec2& to, bool snaps = false) {
  editor.press(from, kReach);
  editor.dragTo((from + to) * 0.5, kReach, 0, snaps);
  editor.dragTo(to, kReach, 0, snaps);
  editor.release();
}

const PlanFace& face(const std::vector<PlanFace>& faces, const std::string& feed) {
  return *std::ranges::find(faces, feed, &PlanFace::feed);
}

TEST(FaceEditor, showsFacesInThePlan) {
  const FaceEditor editor(tSetup());
  const auto faces = editor.faces();
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces[0].feed, "left");
  EXPECT_EQ(faces[0].parent, "stem");
  EXPECT_LT(glm::distance(faces[0].from, {-1.2, 0}), 1e-12);
  EXPECT_LT(glm::distance(faces[0].to, {0, -2.4}), 1e-12);
  EXPECT_DOUBLE_EQ(faces[0].bottom, 0);
  EXPECT_DOUBLE_EQ(faces[0].top, 2.8);
  EXPECT_EQ(editor.problem(), "");
  EXPECT_NE(editor.graph(), nullptr);
}

/// However its corners go around.
TEST(FaceEditor, findsTheUprightSidesOfAFace) {
  FeedFrustum frustum = tSetup().frusta[1];
  const PlanFace expected = planFaceOf(frustum);
  std::rotate(frustum.near.begin(), frustum.near.begin() + 1, frustum.near.end());
  const PlanFace rotated = planFaceOf(frustum);
  const bool isSame =
      glm::distance(rotated.from, expected.from) < 1e-9 && glm::distance(rotated.to, expected.to) < 1e-9;
  const bool isTurned =
      glm::distance(rotated.from, expected.to) < 1e-9 && glm::distance(rotated.to, expected.from) < 1e-9;
  EXPECT_TRUE(isSame || isTurned);
}

TEST(FaceEditor, dragsEndsAndMiddles) {
  FaceEditor editor(tSetup());
  drag(editor, {-1.2, 0.1}, {-1.2, -0.2});
  EXPECT_EQ(editor.selected(), "left");
  EXPECT_LT(glm::distance(face(editor.faces(), "left").from, {-1.2, -0.2}), 1e-9);
  EXPECT_LT(glm::distance(face(editor.faces(), "left").to, {0, -2.4}), 1e-9) << "the other end stays";
  EXPECT_EQ(editor.problem(), "");
  const PlanFace before = face(editor.faces(), "left");
  const glm::dvec2 middle = (before.from + before.to) * 0.5;
  drag(editor, middle, middle + glm::dvec2(-0.3, 0));
  EXPECT_LT(glm::distance(face(editor.faces(), "left").from, before.from + glm::dvec2(-0.3, 0)), 1e-9);
  EXPECT_LT(glm::distance(face(editor.faces(), "left").to, before.to + glm::dvec2(-0.3, 0)), 1e-9);
  editor.undo();
  EXPECT_LT(glm::distance(face(editor.faces(), "left").to, {0, -2.4}), 1e-9);
  editor.undo();
  EXPECT_EQ(editor.setup(), tSetup());
  EXPECT_FALSE(editor.canUndo());
  editor.redo();
  EXPECT_LT(glm::distance(face(editor.faces(), "left").from, {-1.2, -0.2}), 1e-9);
}

TEST(FaceEditor, saysWhatIsNoGraphCameraAndGoesOn) {
  FaceEditor editor(tSetup());
  const auto good = editor.graph();
  editor.press({-1.2, 0}, kReach);
  editor.dragTo({1.0, -0.4}, kReach, 0, false);  // across that of "right"
  EXPECT_NE(editor.problem(), "");
  editor.release();
  EXPECT_NE(editor.problem(), "");
  EXPECT_EQ(editor.graph(), good) << "the last one that was one";
  editor.undo();
  EXPECT_EQ(editor.problem(), "");
  // The camera of "left" stands at x = 5.
  const PlanFace left = face(editor.faces(), "left");
  const glm::dvec2 middle = (left.from + left.to) * 0.5;
  drag(editor, middle, {8, -1.2});
  EXPECT_THAT(editor.problem(), testing::HasSubstr("left"));
}

TEST(FaceEditor, snapsToCornersAndFaces) {
  FaceEditor editor(tSetup(), {{"corner of a wall", {-1.5, 0.5}}});
  editor.press({-1.2, 0}, kReach);
  editor.dragTo({-1.4, 0.4}, kReach, 0, true);
  ASSERT_TRUE(editor.snap());
  EXPECT_EQ(editor.snap()->what, "corner of a wall");
  EXPECT_LT(glm::distance(face(editor.faces(), "left").from, {-1.5, 0.5}), 1e-12);
  editor.dragTo({-1.4, 0.4}, kReach, 0, false);
  EXPECT_LT(glm::distance(face(editor.faces(), "left").from, {-1.4, 0.4}), 1e-12);
  editor.dragTo({1.1, 0.1}, kReach, 0, true);
  EXPECT_EQ(editor.snap()->what, "face of right");
  editor.cancel();
  EXPECT_EQ(editor.setup(), tSetup());
  EXPECT_FALSE(editor.canUndo());
}

TEST(FaceEditor, drawsAFaceOfAFeedThatHasNone) {
  FeedSetup setup = tSetup();
  setup.frusta.pop_back();
  FaceEditor editor(setup);
  editor.select("right");
  drag(editor, {1.2, 0}, {0.01, -2.4});
  ASSERT_EQ(editor.faces().size(), 2u);
  const PlanFace drawn = face(editor.faces(), "right");
  EXPECT_EQ(drawn.parent, "stem");
  EXPECT_DOUBLE_EQ(drawn.top, 2.8) << "as high as the other";
  EXPECT_EQ(editor.problem(), "");
  editor.remove();
  EXPECT_EQ(editor.faces().size(), 1u);
  editor.undo();
  EXPECT_EQ(editor.faces().size(), 2u);
}

TEST(FaceEditor, aPressBesideEverythingDoesNothing) {
  FaceEditor editor(tSetup());
  drag(editor, {4, 4}, {5, 5});
  EXPECT_EQ(editor.setup(), tSetup());
  EXPECT_FALSE(editor.canUndo());
}

TEST(FaceEditor, changesParentsAndHeights) {
  FaceEditor editor(chainSetup());
  editor.select("left");  // "beyond" is a child of it
  editor.changeParent();
  EXPECT_EQ(face(editor.faces(), "left").parent, "right") << "not its own child";
  editor.changeParent();
  EXPECT_EQ(face(editor.faces(), "left").parent, "stem");
  EXPECT_EQ(editor.problem(), "");
  editor.moveTop(-0.5);
  editor.moveBottom(0.2);
  EXPECT_NEAR(face(editor.faces(), "left").top, 2.3, 1e-9);
  EXPECT_NEAR(face(editor.faces(), "left").bottom, 0.2, 1e-9);
  editor.moveTop(-100);
  EXPECT_GE(face(editor.faces(), "left").top, 0.2 + kMinFaceSize - 1e-9);
  editor.undo();
  editor.undo();
  editor.undo();
  editor.remove();
  EXPECT_EQ(face(editor.faces(), "beyond").parent, "stem") << "its children go to its parent";
  editor.select("stem");
  editor.remove();
  editor.changeParent();
  editor.moveTop(1);
  EXPECT_EQ(editor.setup().frusta.size(), 3u) << "the root stays";
  editor.selectNext(-1);
  EXPECT_EQ(editor.selected(), "beyond");
}

}  // namespace
}  // namespace ocelli::test
