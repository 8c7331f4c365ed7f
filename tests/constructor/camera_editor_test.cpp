#include "oc_core/constructor/camera_editor.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

CameraEditor editorOf(const std::string& text) {
  return {text, "camera.json", test::smallCamera(), Box{}};
}

CameraEditor crossroadsEditor() {
  return editorOf(jsonText(test::crossroads()));
}

void apply(CameraEditor& editor, const std::string& edit) {
  editor.apply(quoted(edit), "edit");
}

std::string errorOf(CameraEditor& editor, const std::string& edit) {
  try {
    apply(editor, edit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> namesIn(const CameraEditor& editor) {
  std::vector<std::string> names;
  for (const GraphCamera::Frustum& frustum : std::get<GraphCamera>(editor.camera()).frusta()) {
    names.push_back(frustum.name);
  }
  return names;
}

const std::string kFarRight =
    "{'edit': 'add', 'operation': {'operation': 'bend', 'of': 'right', 'into': {'name': 'far right',"
    " 'plane': {'point': [0.5, 0, -2], 'normal': [0.5, 0, -1]}, 'viewpoint': [-0.5, 0, 4]}}}";

TEST(CameraEditor, addsFrusta) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, kFarRight);
  EXPECT_THAT(namesIn(editor), ElementsAre("root", "left", "right", "far left", "far right"));
}

TEST(CameraEditor, removesWithWhatComesFromIt) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, kFarRight);
  apply(editor,
        "{'edit': 'add', 'operation': {'operation': 'limit', 'of': 'far left',"
        " 'plane': {'point': [0, 0, -9], 'normal': [0, 0, -1]}}}");
  apply(editor, "{'edit': 'remove', 'name': 'left'}");
  EXPECT_THAT(namesIn(editor), ElementsAre("root", "right", "far right"));
}

TEST(CameraEditor, changesFields) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, "{'edit': 'change', 'name': 'far left', 'to': {'viewpoint': [0.6, 0, 4]}}");
  EXPECT_EQ(std::get<GraphCamera>(editor.camera()).frusta()[3].viewpoint, glm::dvec3(0.6, 0, 4));
}

TEST(CameraEditor, renames) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, "{'edit': 'rename', 'name': 'left', 'to': 'west'}");
  EXPECT_THAT(namesIn(editor), ElementsAre("root", "west", "right", "far left"));
}

TEST(CameraEditor, movesTheView) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, "{'edit': 'view', 'view': {'eye': [0, 0, 11]}}");
  EXPECT_EQ(std::get<GraphCamera>(editor.camera()).root().eye(), glm::vec3(0, 0, 11));
}

TEST(CameraEditor, undoesAndRedoes) {
  CameraEditor editor = crossroadsEditor();
  const std::string before = editor.text();
  apply(editor, kFarRight);
  const std::string after = editor.text();
  apply(editor, "{'edit': 'undo'}");
  EXPECT_EQ(editor.text(), before);
  EXPECT_EQ(namesIn(editor).size(), 4u);
  EXPECT_THAT(errorOf(editor, "{'edit': 'undo'}"), HasSubstr("nothing to undo"));
  apply(editor, "{'edit': 'redo'}");
  EXPECT_EQ(editor.text(), after);
  EXPECT_THAT(errorOf(editor, "{'edit': 'redo'}"), HasSubstr("nothing to redo"));
  apply(editor, "{'edit': 'undo'}");
  apply(editor, "{'edit': 'rename', 'name': 'left', 'to': 'west'}");
  EXPECT_THAT(errorOf(editor, "{'edit': 'redo'}"), HasSubstr("nothing to redo")) << "another way was taken";
}

TEST(CameraEditor, aFailedEditLeavesTheCameraAsItWas) {
  CameraEditor editor = crossroadsEditor();
  const std::string before = editor.text();
  for (const char* edit :
       {"{'edit': 'change', 'name': 'left', 'to': {'viewpoint': [0, 0, -9]}}", "{'edit': 'paint'}", "{}",
        "{'edit': 'remove', 'name': 'root'}", "{'edit': 'remove', 'name': 'nowhere'}",
        "{'edit': 'rename', 'name': 'left', 'to': 'right'}", "{'edit': 'change', 'name': 'left', 'to': 3}",
        "{'edit': 'change', 'name': 'left', 'to': {'colour': 3}}", "{'edit': 'add', 'turn': {}}",
        "{'edit': 'view', 'view': 3}", "{'edit': 'undo', 'twice': true}",
        "{'edit': 'remove', 'name': 'left', 'why': 'not'}"}) {
    EXPECT_NE(errorOf(editor, edit), "") << edit;
    EXPECT_EQ(editor.text(), before) << edit;
    EXPECT_EQ(namesIn(editor).size(), 4u) << edit;
  }
}

TEST(CameraEditor, replacesLimits) {
  CameraEditor editor = crossroadsEditor();
  const auto limitsOfRight = [&] { return std::get<GraphCamera>(editor.camera()).frusta()[2].limits.size(); };
  apply(editor,
        "{'edit': 'limits', 'name': 'right', 'planes': [{'point': [0, 0, -9], 'normal': [0, 0, -1]},"
        " {'point': [9, 0, 0], 'normal': [1, 0, 0]}]}");
  EXPECT_EQ(limitsOfRight(), 2U);
  apply(editor, "{'edit': 'limits', 'name': 'right', 'planes': [{'point': [0, 0, -8], 'normal': [0, 0, -1]}]}");
  EXPECT_EQ(limitsOfRight(), 1U);
  apply(editor, "{'edit': 'limits', 'name': 'right', 'planes': []}");
  EXPECT_EQ(limitsOfRight(), 0U);
  EXPECT_THAT(errorOf(editor, "{'edit': 'limits', 'name': 'right', 'planes': 3}"), HasSubstr("array of planes"));
}

TEST(CameraEditor, severalEditsAreOneStep) {
  CameraEditor editor = crossroadsEditor();
  const std::string before = editor.text();
  apply(editor,
        "{'edit': 'several', 'edits': [{'edit': 'rename', 'name': 'left', 'to': 'west'},"
        " {'edit': 'rename', 'name': 'right', 'to': 'east'}]}");
  EXPECT_THAT(namesIn(editor), ElementsAre("root", "west", "east", "far left"));
  apply(editor, "{'edit': 'undo'}");
  EXPECT_EQ(editor.text(), before);
  EXPECT_FALSE(editor.canUndo());
  EXPECT_TRUE(editor.canRedo());
  EXPECT_THAT(errorOf(editor,
                      "{'edit': 'several', 'edits': [{'edit': 'rename', 'name': 'left', 'to': 'west'},"
                      " {'edit': 'remove', 'name': 'left'}]}"),
              HasSubstr("edit 2"));
  EXPECT_EQ(editor.text(), before);
  for (const char* wrong :
       {"5", "{}", "{'operation': 5}", "{'into': 5}", "{'into': [5]}", "{'into': {'name': 5}, 'of': 5}"}) {
    for (const char* then : {"{'edit': 'limits', 'name': 'right', 'planes': []}", "{'edit': 'remove', 'name': 'left'}",
                             "{'edit': 'rename', 'name': 'left', 'to': 'west'}"}) {
      EXPECT_NE(errorOf(editor, "{'edit': 'several', 'edits': [{'edit': 'add', 'operation': " + std::string(wrong) +
                                    "}, " + then + "]}"),
                "")
          << wrong << then;
    }
  }
  EXPECT_EQ(editor.text(), before);
  EXPECT_THAT(errorOf(editor, "{'edit': 'several', 'edits': [{'edit': 'several', 'edits': []}]}"), HasSubstr("within"));
  EXPECT_THAT(errorOf(editor, "{'edit': 'several', 'edits': [{'edit': 'undo'}]}"), HasSubstr("must be"));
}

TEST(CameraEditor, triesAnEditWithoutDoingIt) {
  CameraEditor editor = crossroadsEditor();
  const std::string before = editor.text();
  const std::string tried = editor.edited(R"({"edit": "rename", "name": "left", "to": "west"})", "edit");
  EXPECT_EQ(editor.text(), before);
  EXPECT_THAT(tried, HasSubstr("\"west\""));
  const MultiperspectiveCamera camera = CameraEditor::cameraOf(tried, "edit", test::smallCamera(), Box{});
  EXPECT_EQ(std::get<GraphCamera>(camera).frusta()[1].name, "west");
}

TEST(CameraEditor, saysWhetherFrustaMayOverlap) {
  CameraEditor editor = crossroadsEditor();
  apply(editor, "{'edit': 'overlap', 'overlap': 'refused'}");
  EXPECT_THAT(editor.text(), HasSubstr("refused"));
  EXPECT_THAT(errorOf(editor, "{'edit': 'overlap', 'overlap': 'maybe'}"), HasSubstr("refused or allowed"));
  CameraEditor curved = editorOf(quoted("{'camera': 'curved', 'turns': []}"));
  EXPECT_THAT(errorOf(curved, "{'edit': 'overlap', 'overlap': 'allowed'}"), HasSubstr("of a graph camera"));
  EXPECT_THAT(errorOf(curved, "{'edit': 'limits', 'name': 'root', 'planes': []}"), HasSubstr("of a graph camera"));
}

TEST(CameraEditor, editsTurns) {
  CameraEditor editor = editorOf(quoted("{'camera': 'curved', 'turns': []}"));
  const auto bends = [&] { return std::get<CurvedRayCamera>(editor.camera()).bends().size(); };
  apply(editor,
        "{'edit': 'add', 'turn': {'name': 'right', 'from': {'point': [4, 0, 0], 'normal': [-0.25, 0, -1]},"
        " 'middle': {'point': [4, 0, 0], 'normal': [0, 0, -1]},"
        " 'to': {'point': [4, 0, 0], 'normal': [0.25, 0, -1]}, 'viewpoint': [-2, 0, 6]}}");
  EXPECT_EQ(bends(), 1u);
  apply(editor, "{'edit': 'change', 'name': 'right', 'to': {'viewpoint': [-1, 0, 6]}}");
  EXPECT_EQ(std::get<CurvedRayCamera>(editor.camera()).bends()[0].beyond(), glm::dvec3(-1, 0, 6));
  apply(editor, "{'edit': 'remove', 'name': 'right'}");
  EXPECT_EQ(bends(), 0u);
}

TEST(CameraEditor, turnsOfACameraHaveNames) {
  CameraEditor editor = editorOf(jsonText(test::bendingTwice()));
  apply(editor, "{'edit': 'remove', 'name': 'turn 2'}");
  EXPECT_EQ(std::get<CurvedRayCamera>(editor.camera()).bends().size(), 1u);
}

TEST(CameraEditor, startsFromTheFileAsItStands) {
  const test::TemporaryFolder folder;
  const std::string text = quoted("{'camera': 'graph', /* mine */ 'operations': []}");
  const GraphCamera constructed = test::crossroads();
  EXPECT_EQ(editableText(folder.write("mine.json", text).string(), constructed), text);
  const std::string other = folder.write("other.json", quoted("{'camera': 'portal'}")).string();
  EXPECT_EQ(editableText(other, constructed), jsonText(constructed));
  EXPECT_EQ(editableText("portal", constructed), jsonText(constructed));
}

TEST(CameraEditor, startsFromACameraAlone) {
  EXPECT_THROW(editorOf(quoted("{'camera': 'ddoc'}")), InputError);
  EXPECT_THROW(editorOf("[]"), InputError);
  EXPECT_THROW(editorOf("{"), InputError);
}

}  // namespace
}  // namespace ocelli
