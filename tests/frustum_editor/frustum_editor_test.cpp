#include "oc_core/frustum_editor/frustum_editor.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/frustum_editor/editor_preview.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "tests/base/temporary_folder.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

class FrustumEditorTest : public testing::Test {
 protected:
  /// Two halves that look to the outside.
  void splitApart() {
    fixture.stroke("split", {0, 2}, {4, 3});
    fixture.drag("frustum 1 left", "viewpoint", 0, {2, 8});
    fixture.drag("frustum 1 right", "viewpoint", 0, {-2, 8});
    ASSERT_EQ(fixture.editor.message(), "");
  }
  test::EditorFixture fixture;
  FrustumEditor& editor = fixture.editor;
};

TEST_F(FrustumEditorTest, aDragIsOneStepOfUndo) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  const std::string before = editor.text();
  editor.chooseTool("move");
  editor.press(test::EditorFixture::at(0, 8));  // the eye, and the viewpoint of the frustum on it
  ASSERT_TRUE(editor.isDragging());
  const std::string moved = editor.selectedFrustum();
  EXPECT_EQ(moved, "frustum 1");  // the selected one before others
  for (int i = 1; i <= 10; ++i) {
    editor.dragTo(test::EditorFixture::at(0.1 * i, 8 + 0.1 * i));
    EXPECT_NE(editor.text(), before);  // the camera follows
  }
  editor.release();
  const std::string after = editor.text();
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.text(), before);
  EXPECT_TRUE(editor.redo());
  EXPECT_EQ(editor.text(), after);
  EXPECT_FALSE(editor.redo());
  EXPECT_THAT(editor.message(), HasSubstr("nothing to redo"));
}

// The file says what shape its images have; whole rows come near to it, whatever the width.
TEST(FrustumEditorSizes, smallImagesKeepTheShapeOfNarrowOnes) {
  for (const glm::ivec2& size : {glm::ivec2(15, 199), glm::ivec2(199, 15), glm::ivec2(7, 5), glm::ivec2(1, 1)}) {
    const PinholeCamera root = test::editorRoot(size.x, size.y);
    const Mesh mesh = test::editorMesh();
    const FrustumEditor narrow(FrustumEditor::newGraphCamera(root), "new camera", root, mesh, {});
    for (int width = 1; width <= size.x; ++width) {
      EXPECT_NO_THROW(narrow.cameraOfWidth(width)) << width << " of " << size.x << "x" << size.y;
    }
    EditorPreview preview(narrow, mesh);
    EXPECT_FALSE(preview.next()->isWhole);
    EXPECT_TRUE(preview.next()->isWhole);
  }
}

TEST_F(FrustumEditorTest, aDragIntoWhatIsNoCameraKeepsTheLastOne) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  editor.chooseTool("move");
  editor.selectHandle(PlanSide::kTop, "frustum 1", "plane", 0);
  editor.press(test::EditorFixture::at(0, 2));
  editor.dragTo(test::EditorFixture::at(0, 3));
  ASSERT_EQ(editor.message(), "");
  const std::string valid = editor.text();
  editor.dragTo(test::EditorFixture::at(0, 9));  // behind the eye
  EXPECT_NE(editor.message(), "");
  EXPECT_EQ(editor.text(), valid);
  editor.release();
  EXPECT_EQ(editor.text(), valid);
  EXPECT_NE(editor.message(), "");  // why it is not where the pointer was
}

TEST_F(FrustumEditorTest, anOverlapIsShownWithItsWitnessAndRefused) {
  splitApart();
  const std::string apart = editor.text();
  editor.chooseTool("move");
  editor.selectHandle(PlanSide::kTop, "frustum 1 left", "viewpoint", 0);
  editor.press(test::EditorFixture::at(2, 8));
  editor.dragTo(test::EditorFixture::at(-5, 8));
  ASSERT_EQ(editor.drawn().overlaps.size(), 1U);
  EXPECT_THAT(editor.message(), HasSubstr("both hold the point"));
  EXPECT_EQ(editor.text(), apart);  // the image stays
  editor.release();
  EXPECT_EQ(editor.text(), apart);
  EXPECT_TRUE(editor.drawn().overlaps.empty());
}

TEST_F(FrustumEditorTest, overlapsCanBeAllowed) {
  splitApart();
  EXPECT_TRUE(editor.allowOverlap(true));
  fixture.drag("frustum 1 left", "viewpoint", 0, {-5, 8});
  EXPECT_EQ(fixture.frustum("frustum 1 left").viewpoint.x, -5);
  EXPECT_EQ(editor.drawn().overlaps.size(), 1U);
  EXPECT_THAT(editor.message(), HasSubstr("overlap"));  // a note
  EXPECT_FALSE(editor.allowOverlap(false));             // not while there is one
  EXPECT_THAT(editor.message(), HasSubstr("both hold the point"));
}

TEST_F(FrustumEditorTest, cancelLeavesTheDrag) {
  const std::string before = editor.text();
  editor.chooseTool("bend");
  editor.press(test::EditorFixture::at(-6, 2));
  editor.dragTo(test::EditorFixture::at(6, 2));
  EXPECT_NE(editor.text(), before);
  editor.cancel();
  EXPECT_EQ(editor.text(), before);
  EXPECT_FALSE(editor.canUndo());
  EXPECT_EQ(editor.drawn().frusta.size(), 1U);
}

TEST_F(FrustumEditorTest, renamesWithWhatComesFromIt) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  fixture.stroke("bend", {-8, -2}, {8, -2});
  editor.select("frustum 1");
  EXPECT_TRUE(editor.renameSelected("street"));
  EXPECT_EQ(fixture.frustum("frustum 2").of.at(0), "street");
  EXPECT_EQ(editor.selectedFrustum(), "street");
  EXPECT_FALSE(editor.renameSelected("frustum 2"));
  EXPECT_THAT(editor.message(), HasSubstr("already"));
  EXPECT_FALSE(editor.renameSelected(""));
  editor.select("root");
  EXPECT_FALSE(editor.renameSelected("trunk"));
  EXPECT_FALSE(editor.removeSelected());
  editor.select("street");
  EXPECT_TRUE(editor.removeSelected());
  EXPECT_EQ(editor.drawn().frusta.size(), 1U);
  EXPECT_EQ(editor.selectedFrustum(), "");
}

TEST_F(FrustumEditorTest, everythingGoesByKeyboard) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  editor.select("root");
  std::set<std::string> seen;
  const size_t count = handlesOf(editor.drawn(), PlanSide::kTop).size();
  for (size_t i = 0; i < count; ++i) {
    editor.selectNextHandle(PlanSide::kTop);
    const FrustumHandle handle = *editor.selectedHandle(PlanSide::kTop);
    seen.insert(handle.frustum + handle.kind->name + std::to_string(handle.index));
  }
  EXPECT_EQ(seen.size(), count);
  editor.selectNextHandle(PlanSide::kTop, -1);
  editor.selectHandle(PlanSide::kTop, "frustum 1", "viewpoint", 0);
  EXPECT_TRUE(editor.nudge(PlanSide::kTop, {0.5, 0.25}));
  EXPECT_EQ(fixture.frustum("frustum 1").viewpoint, glm::dvec3(0.5, 1.5, 8.25));
  EXPECT_FALSE(editor.typeNumber(PlanSide::kTop, "weight", 1));
  EXPECT_THAT(editor.message(), HasSubstr("x, y, z, distance"));
}

TEST_F(FrustumEditorTest, clicksGoThroughHandlesThatLieOnEachOther) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  editor.chooseTool("move");
  // The eye of the root, and the viewpoint of the frustum.
  std::vector<std::string> kinds;
  for (int i = 0; i < 3; ++i) {
    editor.press(test::EditorFixture::at(0, 8));
    editor.release();
    kinds.push_back(editor.selectedHandle(PlanSide::kTop)->kind->name);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"viewpoint", "eye", "viewpoint"}));
  EXPECT_EQ(fixture.frustum("root").viewpoint, glm::dvec3(0, 1.5, 8));  // nothing moved
}

TEST_F(FrustumEditorTest, aWrongFileLeavesTheEditorAsItWas) {
  fixture.stroke("bend", {-6, 2}, {6, 2});
  const std::string before = editor.text();
  EXPECT_FALSE(editor.open("{\"camera\": \"graph\"}", "other.json"));
  EXPECT_THAT(editor.message(), HasSubstr("other.json"));
  EXPECT_FALSE(editor.open("no JSON", "other.json"));
  EXPECT_FALSE(editor.open("{\"camera\": \"portal\"}", "other.json"));
  EXPECT_THAT(editor.message(), HasSubstr("graph or curved"));
  EXPECT_FALSE(editor.open("[]", "other.json"));
  EXPECT_EQ(editor.text(), before);
  EXPECT_TRUE(editor.canUndo());
}

TEST_F(FrustumEditorTest, aFileIsOpenedInTheShapeThatItIsMadeFor) {
  const std::string text = FrustumEditor::newGraphCamera(test::editorRoot(100, 50));
  ASSERT_TRUE(editor.open(text, "wide.json")) << editor.message();
  EXPECT_EQ(editor.drawn().imageSize(), glm::dvec2(100, 50));
  EXPECT_FALSE(
      editor.open("{\"camera\": \"graph\", \"size\": {\"width\": 0, \"height\": 5}, \"operations\": []}", "x"));
  EXPECT_EQ(editor.text(), text);
}

TEST_F(FrustumEditorTest, aCameraOfAnotherSceneIsSaid) {
  View view = test::editorView();
  view.eye += glm::vec3(5000, 0, 0);
  view.target += glm::vec3(5000, 0, 0);
  EXPECT_TRUE(editor.open(FrustumEditor::newGraphCamera(PinholeCamera(view, 64, 36)), "other.json"));
  EXPECT_THAT(editor.message(), HasSubstr("another scene"));
}

TEST_F(FrustumEditorTest, aSceneWithoutTrianglesIsRefused) {
  const Mesh empty;
  EXPECT_THROW(FrustumEditor(editor.text(), "new", test::editorRoot(), empty, {}), InputError);
}

TEST_F(FrustumEditorTest, turnsWithoutNamesGetOne) {
  const std::string planes = R"("from": {"point": [7, 0, 0], "normal": [-0.25, 0, -1]},
    "middle": {"point": [7, 0, 0], "normal": [0, 0, -1]}, "to": {"point": [7, 0, 0], "normal": [0.25, 0, -1]},
    "viewpoint": [-2, 1.5, 6])";
  ASSERT_TRUE(editor.open("{\"camera\": \"curved\", \"turns\": [{" + planes + "}]}", "curved.json"))
      << editor.message();
  ASSERT_NE(editor.drawn().find("turn 1"), nullptr);
  fixture.drag("turn 1", "viewpoint", 0, {-2.5, 6});
  EXPECT_EQ(editor.message(), "");
}

TEST_F(FrustumEditorTest, whatIsSavedIsWhatTheCameraOptionDraws) {
  splitApart();
  fixture.stroke("limit", {-9, -3}, {-1, -3});
  const test::TemporaryFolder folder;
  const std::string file = folder.write("drawn.json", editor.text()).string();
  GuidedScene scene;
  scene.mesh = fixture.mesh;
  const MultiperspectiveCamera again = constructCamera(file, scene, test::editorRoot());
  const FragmentImage one = rasterize(editor.camera(), fixture.mesh);
  const FragmentImage other = rasterize(again, fixture.mesh);
  const Image<glm::vec3> a = colorImage(one, fixture.mesh, skyColor());
  const Image<glm::vec3> b = colorImage(other, fixture.mesh, skyColor());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  // And it is opened again as it was.
  const std::string text = editor.text();
  EXPECT_TRUE(editor.open(text, file));
  EXPECT_EQ(editor.text(), text);
}

TEST_F(FrustumEditorTest, theImageComesSmallFirst) {
  EditorPreview preview(editor, fixture.mesh);
  const std::optional<PreviewImage> small = preview.next();
  ASSERT_TRUE(small);
  EXPECT_FALSE(small->isWhole);
  EXPECT_EQ(small->image.width(), 16);
  EXPECT_EQ(small->image.height(), 9);
  const std::optional<PreviewImage> whole = preview.next();
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->isWhole);
  EXPECT_EQ(whole->image.width(), 64);
  EXPECT_FALSE(preview.next());
  editor.chooseTool("bend");
  editor.press(test::EditorFixture::at(-6, 2));
  editor.dragTo(test::EditorFixture::at(6, 2));
  EXPECT_FALSE(preview.next()->isWhole);
  editor.dragTo(test::EditorFixture::at(6, 2.5));  // goes on: the whole one has to wait
  EXPECT_FALSE(preview.next()->isWhole);
  editor.release();
  EXPECT_TRUE(preview.next()->isWhole);
}

}  // namespace
}  // namespace ocelli
