// Scripts that make no sense: each ends with an error that names its step, and none leaves a camera that is none.
#include <gmock/gmock.h>

#include "tests/frustum_editor/editor_script_player.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class EditorNonsense : public test::EditorScriptPlayer {};

TEST_F(EditorNonsense, stepsThatDoNothingSaySo) {
  EXPECT_THAT(errorOf("{'undo': 1}"), AllOf(HasSubstr("step 1"), HasSubstr("nothing to undo")));
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'redo': 3}"), AllOf(HasSubstr("step 2"), HasSubstr("nothing to redo")));
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'stroke': [[-6, 2], [6, 2]]}, {'undo': 2}"),
              AllOf(HasSubstr("step 3"), HasSubstr("nothing to undo")));
  EXPECT_THAT(errorOf("{'drag': [1, 2]}"), AllOf(HasSubstr("step 1"), HasSubstr("nothing is being dragged")));
  EXPECT_THAT(errorOf("{'release': true}"), AllOf(HasSubstr("step 1"), HasSubstr("nothing is being dragged")));
  EXPECT_THAT(errorOf("{'tool': 'merge'}, {'stroke': [[0, 3], [0.2, 2.9]]}"),
              AllOf(HasSubstr("step 2"), HasSubstr("from one frustum to another")));
  EXPECT_THAT(errorOf("{'tool': 'add'}, {'stroke': [[0, 2], [0, 2]]}"),
              AllOf(HasSubstr("step 2"), HasSubstr("too short")));
  EXPECT_THAT(errorOf("{'tool': 'turn'}"), AllOf(HasSubstr("step 1"), HasSubstr("curved ray cameras")));
  EXPECT_THAT(errorOf("{'nudge': [1, 2]}"), AllOf(HasSubstr("step 1"), HasSubstr("No handle")));
  EXPECT_THAT(errorOf("{'rename': 'root'}"), AllOf(HasSubstr("step 1"), HasSubstr("No frustum")));
  EXPECT_THAT(errorOf("{'select': 'root'}, {'remove': true}"), AllOf(HasSubstr("step 2"), HasSubstr("root stays")));
}

TEST_F(EditorNonsense, strokesOutsideOfThePlanDrawNothing) {
  for (const char* tool : {"bend", "add", "split", "merge", "limit", "delete"}) {
    for (const char* stroke : {"[[1e6, 1e6], [-1e6, 1e6]]", "[[0, 900000], [0, 900000]]", "[[-1e6, 0], [-1e6, 5]]"}) {
      for (const char* side : {"top", "front", "right"}) {
        const std::string error =
            errorOf(std::string("{'tool': '") + tool + "'}, {'stroke': " + stroke + ", 'plan': '" + side + "'}");
        EXPECT_TRUE(error.empty() || error.find("step 2") != std::string::npos) << tool << stroke << side << error;
      }
    }
  }
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'stroke': [[1e6, 1e6], [1e6, 1e6]]}"),
              AllOf(HasSubstr("step 2"), HasSubstr("no rays of the camera; try: draw where")));
}

TEST_F(EditorNonsense, frustaWithoutLengthAreSplitOrRefused) {
  // All rays of the second frustum end where it begins.
  const std::string flat =
      "{'tool': 'bend'}, {'stroke': [[-6, 2], [6, 2]]}, {'select': 'frustum 1'}, {'tool': 'limit'},"
      "{'stroke': [[-6, 2], [6, 2]]}, ";
  for (const char* last :
       {"{'tool': 'split'}, {'stroke': [[0, 2], [3, 3]]}", "{'tool': 'bend'}, {'stroke': [[0, 2], [0, 2]]}",
        "{'tool': 'add'}, {'stroke': [[-1, 2], [1, 2]]}"}) {
    const std::string error = errorOf(flat + last);
    EXPECT_TRUE(error.empty() || error.find("step ") != std::string::npos) << last << ": " << error;
  }
}

TEST_F(EditorNonsense, numbersThatAreNoneAreNamed) {
  EXPECT_THAT(errorOf("{'tool': 'bend'}, {'press': [1e7, 0]}"), AllOf(HasSubstr("step 2"), HasSubstr("press")));
  EXPECT_THAT(errorOf("{'press': [NaN, 0]}"), HasSubstr("script.json"));
  EXPECT_THAT(errorOf("{'press': [1e999, 0]}"), HasSubstr("script.json"));
  EXPECT_THAT(errorOf("{'press': ['a', null]}"), AllOf(HasSubstr("step 1"), HasSubstr("press")));
  EXPECT_THAT(errorOf("{'stroke': [[0, 1], [0]]}"), AllOf(HasSubstr("step 1"), HasSubstr("stroke")));
  EXPECT_THAT(errorOf("{'undo': 0}"), AllOf(HasSubstr("step 1"), HasSubstr("undo")));
  EXPECT_THAT(errorOf("{'undo': 1.5}"), AllOf(HasSubstr("step 1"), HasSubstr("undo")));
  EXPECT_THAT(errorOf("{'next': 1e18}"), AllOf(HasSubstr("step 1"), HasSubstr("next")));
  EXPECT_THAT(errorOf("3"), HasSubstr("step 1"));
  EXPECT_THAT(errorOf("{'edit': {'edit': 'several', 'edits': [{'edit': 'several', 'edits': []}]}}"),
              HasSubstr("step 1"));
  EXPECT_THAT(errorOf("{'edit': 'undo'}"), HasSubstr("step 1"));
  EXPECT_THAT(errorOfText(R"({"size": [0, 5], "steps": []})"), HasSubstr("size"));
  EXPECT_THAT(errorOfText(R"({"camera": "none.json", "steps": []})"), HasSubstr("none.json"));
  EXPECT_THAT(errorOfText(R"({"steps": {}})"), HasSubstr("steps"));
  EXPECT_THAT(errorOfText("[]"), HasSubstr("script.json"));
}

// Every number of every handle, as large as scripts may say: it is taken, or refused by its step.
TEST_F(EditorNonsense, hugeNumbersLeaveACamera) {
  const std::string drawn =
      "{'tool': 'split'}, {'stroke': [[0, 3], [4, 4]]}, {'tool': 'limit'}, {'stroke': [[-6, -4], [-1, -4]]},";
  size_t taken = 0;
  size_t refused = 0;
  for (const char* side : {"top", "front", "right"}) {
    EditorSession session = play(drawn + "{'overlap': 'allowed'}");
    FrustumEditor& editor = session.editor();
    const PlanSide plan = side[0] == 't' ? PlanSide::kTop : side[0] == 'f' ? PlanSide::kFront : PlanSide::kRight;
    const size_t handles = handlesOf(editor.drawn(), plan).size();
    for (size_t i = 0; i < handles; ++i) {
      for (const double value : {0.0, 1e6, -1e6, 1e-300}) {
        for (const HandleNumber& number : [&] {
               editor.selectNextHandle(plan);
               return editor.numbers(plan);
             }()) {
          const bool done = editor.typeNumber(plan, number.name, value);
          done ? ++taken : ++refused;
          EXPECT_TRUE(done || !editor.message().empty());
          ASSERT_NO_THROW(CameraEditor::cameraOf(editor.text(), "drawn", test::editorRoot(), boundsOf(mesh)));
          EXPECT_TRUE(!done || editor.undo());
        }
      }
    }
  }
  EXPECT_GT(taken, 50u);
  EXPECT_GT(refused, 50u);
}

TEST_F(EditorNonsense, hasAtMostTenThousandSteps) {
  const auto steps = [](size_t count) {
    std::string text = "{'tool': 'move'}";
    for (size_t i = 1; i < count; ++i) {
      text += ", {'tool': 'bend'}";
    }
    return text;
  };
  EXPECT_THAT(errorOf(steps(10001)), AllOf(HasSubstr("steps"), HasSubstr("10000")));
  EXPECT_EQ(errorOf(steps(10000)), "");
  EXPECT_THAT(errorOf(steps(9999) + ", {'undo': 2}"), AllOf(HasSubstr("step 10000"), HasSubstr("nothing to undo")));
}

}  // namespace
}  // namespace ocelli
