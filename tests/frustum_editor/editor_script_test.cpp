#include "oc_core/frustum_editor/editor_script.h"

#include <gmock/gmock.h>

#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_document.h"
#include "oc_core/drawing/drawing.h"
#include "tests/frustum_editor/editor_script_player.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

class EditorScriptTest : public test::EditorScriptPlayer {};

TEST_F(EditorScriptTest, drawsAndWritesWhatWasDrawn) {
  EditorSession session = play(
      "{'tool': 'bend'}, {'press': [-6, 2]}, {'drag': [0, 2]}, {'drag': [6, 2]}, {'release': true},"
      "{'rename': 'ahead'}, {'handle': 'viewpoint', 'of': 'ahead'}, {'move': [1, 8]},"
      "{'number': 'y', 'is': 1.75}, {'nudge': [0.5, 0]},"
      "{'handle': 'viewpoint', 'of': 'ahead', 'plan': 'right'}, {'nudge': [0, 0.25], 'plan': 'right'},"
      "{'save': 'out/drawn.json'}, {'image': 'drawn.png'}, {'plan_image': 'plan.svg', 'plan': 'top'},"
      "{'plan_image': 'side.svg', 'plan': 'right', 'from': [-10, 0], 'to': [10, 4]}");
  EXPECT_EQ(session.editor().drawn().find("ahead")->viewpoint, glm::dvec3(1.5, 2, 8));
  EXPECT_EQ(readFile(folder.path() / "out" / "drawn.json"), session.editor().text());
  EXPECT_EQ(readPng(folder.path() / "drawn.png").width(), 64);
  EXPECT_THAT(readFile(folder.path() / "plan.svg"), HasSubstr("2 frusta"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "side.svg"));
}

TEST_F(EditorScriptTest, undoesAndRedoes) {
  EditorSession session = play(
      "{'tool': 'bend'}, {'stroke': [[-6, 2], [6, 2]]}, {'tool': 'limit'}, {'stroke': [[-6, -4], [6, -4]]},"
      "{'undo': 2}, {'redo': 1}");
  EXPECT_EQ(session.editor().drawn().frusta.size(), 2U);
  EXPECT_TRUE(session.editor().canRedo());
}

TEST_F(EditorScriptTest, saysWhichStepCannotBeDone) {
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'stroke': [[-9, 8], [-9, 7]]}"), HasSubstr("script.json, step 2"));
  EXPECT_EQ(errorOf("{'tool': 'bend'}, {'stroke': [[-9, 8], [-9, 7]], 'refused': true}"), "");
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'stroke': [[-6, 2], [6, 2]], 'refused': true}"),
              HasSubstr("should be refused"));
  EXPECT_THAT(errorOf("{'undo': 1}"), HasSubstr("nothing to undo"));
  EXPECT_THAT(errorOf("{'handle': 'viewpoint', 'of': 'nobody'}"), HasSubstr("nobody"));
  EXPECT_THAT(errorOf("{'move': [1, 2]}"), HasSubstr("no handle"));
}

TEST_F(EditorScriptTest, refusesWhatIsNoScript) {
  EXPECT_THAT(errorOf("{}"), HasSubstr("does nothing"));
  EXPECT_THAT(errorOf("{'undo': 1, 'redo': 1}"), HasSubstr("two things"));
  EXPECT_THAT(errorOf("{'tool': 'paint'}"), HasSubstr("paint"));
  EXPECT_THAT(errorOf("{'press': [1]}"), HasSubstr("press"));
  EXPECT_THAT(errorOf("{'press': [1, 2], 'plan': 'left'}"), HasSubstr("top, front or right"));
  EXPECT_THAT(errorOf("{'undo': 1, 'color': 'red'}"), HasSubstr("color"));
  EXPECT_THAT(errorOf("{'save': '../drawn.json'}"), HasSubstr("no file in the folder"));
  EXPECT_THAT(errorOf("{'stroke': []}"), HasSubstr("stroke"));
}

TEST_F(EditorScriptTest, goesOnWithACameraFile) {
  play("{'tool': 'bend'}, {'stroke': [[-6, 2], [6, 2]]}, {'save': 'first.json'}");
  const EditorScript script = editorScriptFromJsonText(
      R"({"camera": "first.json", "size": [64, 36], "steps": [{"select": "frustum 1"}, {"rename": "ahead"}]})",
      "next.json");
  EditorSession session = playEditorScript(script, folder.path(), test::editorView(), mesh, {}, folder.path());
  EXPECT_NE(session.editor().drawn().find("ahead"), nullptr);
}

TEST(EditorScriptSchema, hasEveryStepToolAndHandle) {
  const nlohmann::json schema = readJsonFile(OCELLI_EDITOR_SCRIPT_SCHEMA);
  const nlohmann::json& step = schema.at("properties").at("steps").at("items").at("properties");
  std::set<std::string> described;
  for (const auto& [name, property] : step.items()) {
    described.insert(name);
  }
  // What belongs to steps besides their own fields.
  for (const char* name : {"plan", "snap", "reach", "of", "index", "is", "from", "to", "refused", "comment"}) {
    EXPECT_EQ(described.erase(name), 1U) << name;
  }
  std::set<std::string> steps;
  for (const EditorStepKind& kind : editorStepKinds()) {
    steps.insert(kind.name);
  }
  EXPECT_EQ(described, steps);
  std::vector<std::string> tools;
  for (const EditorTool& tool : editorTools()) {
    tools.push_back(tool.name);
  }
  EXPECT_EQ(step.at("tool").at("enum").get<std::vector<std::string>>(), tools);
  std::vector<std::string> handles;
  for (const HandleKind& kind : handleKinds()) {
    handles.push_back(kind.name);
  }
  EXPECT_EQ(step.at("handle").at("enum").get<std::vector<std::string>>(), handles);
}

TEST_F(EditorScriptTest, drawsOverlapsInRedWithTheirWitness) {
  EditorSession session = play(
      "{'tool': 'split'}, {'stroke': [[0, 2], [4, 3]]}, {'overlap': 'allowed'},"
      "{'handle': 'viewpoint', 'of': 'frustum 1 left'}, {'move': [-5, 8]}");
  const PlanWindow window = PlanWindow::around(PlanSide::kTop, boundsOf(mesh), {400, 400});
  const Drawing drawing = planDrawing(session.editor(), window, nullptr);
  const auto count = [&](const std::string& part) {
    return std::count_if(drawing.shapes().begin(), drawing.shapes().end(),
                         [&](const Shape& shape) { return shape.part == part; });
  };
  EXPECT_GE(count("overlap"), 1);
  EXPECT_GE(count("witness"), 1);
  EXPECT_EQ(count("selected handle"), 1);
  EXPECT_EQ(count("plane"), 2);
  EXPECT_TRUE(isFinite(drawing));
  const Figure figure = editorFigure(session.editor(), window, &session.backdrop(PlanSide::kTop));
  EXPECT_THAT(figure.description, HasSubstr("1 overlaps"));
  EXPECT_GT(figure.height, 400);  // the message stands below
}

}  // namespace
}  // namespace ocelli
