// Random drags and strokes, from a seed: whatever one does, the editor holds a camera that its file gives again, and
// undo leads back to the very bytes.
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

class RandomHand {
 public:
  RandomHand(test::EditorFixture& fixture, uint64_t seed) : fixture_(fixture), random_(seed) {}

  void act() {
    const std::vector<EditorTool>& tools = editorTools();
    // Mostly handles: strokes of tools make frusta, and without an end they would be many.
    const size_t choice = random_.below(2 * tools.size());
    fixture_.editor.chooseTool(choice < tools.size() ? tools[choice].name : "move");
    const PlanSide side = static_cast<PlanSide>(random_.below(3));
    press(side);
    const int steps = static_cast<int>(random_.below(4));
    for (int i = 0; i < steps; ++i) {
      fixture_.editor.dragTo(pointer(side));
      expectCamera();
    }
    if (random_.below(8) == 0) {
      fixture_.editor.cancel();
    } else {
      fixture_.editor.release();
    }
    expectCamera();
  }

  void typeSomething() {
    const PlanSide side = static_cast<PlanSide>(random_.below(3));
    fixture_.editor.selectNextHandle(side, 1 + static_cast<int>(random_.below(5)));
    const std::vector<HandleNumber> numbers = fixture_.editor.numbers(side);
    if (!numbers.empty()) {
      const HandleNumber& number = numbers[random_.below(numbers.size())];
      fixture_.editor.typeNumber(side, number.name, number.value + random_.inRange(-30, 30));
    }
    expectCamera();
  }

 private:
  PlanPointer pointer(PlanSide side) {
    return {side,
            {random_.inRange(-12, 12), side == PlanSide::kTop ? random_.inRange(-12, 12) : random_.inRange(-5, 1)},
            0.5,
            random_.below(2) == 0};
  }
  void press(PlanSide side) {
    const std::vector<FrustumHandle> handles = handlesOf(fixture_.editor.drawn(), side);
    PlanPointer at = pointer(side);
    if (random_.below(2) == 0) {
      at.paper = paperFromWorld(side, handles[random_.below(handles.size())].at);
    }
    fixture_.editor.press(at);
  }
  /// The file gives the camera: it reads, and says the same.
  void expectCamera() {
    const std::string& text = fixture_.editor.text();
    ASSERT_NO_THROW(CameraEditor::cameraOf(text, "drawn", test::editorRoot(), boundsOf(fixture_.mesh))) << text;
  }

  test::EditorFixture& fixture_;
  Random random_;
};

class EditorFuzz : public testing::TestWithParam<bool> {};

TEST_P(EditorFuzz, randomDragsNeverLeaveAWrongCamera) {
  size_t done = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    test::EditorFixture fixture;
    if (GetParam()) {
      ASSERT_TRUE(fixture.editor.open(FrustumEditor::newCurvedCamera(test::editorRoot()), "new"));
    }
    RandomHand hand(fixture, seed);
    std::vector<std::string> texts{fixture.editor.text()};
    for (int i = 0; i < 60; ++i) {
      if (i % 5 == 4) {
        hand.typeSomething();
      } else {
        hand.act();
      }
      if (HasFatalFailure()) {
        return;
      }
      if (fixture.editor.text() != texts.back()) {
        texts.push_back(fixture.editor.text());
      }
    }
    done += texts.size() - 1;
    // Back through all of it: steps that changed nothing in the text are steps as well.
    std::vector<std::string> back{fixture.editor.text()};
    while (fixture.editor.canUndo()) {
      ASSERT_TRUE(fixture.editor.undo()) << fixture.editor.message();
      if (fixture.editor.text() != back.back()) {
        back.push_back(fixture.editor.text());
      }
    }
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(back, texts) << "seed " << seed;
  }
  EXPECT_GT(done, 100U);  // it drew something
}

INSTANTIATE_TEST_SUITE_P(BothCameras, EditorFuzz, testing::Bool(),
                         [](const auto& chosen) { return chosen.param ? "curved" : "graph"; });

}  // namespace
}  // namespace ocelli
