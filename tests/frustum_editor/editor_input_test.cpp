#include "oc_core/frustum_editor/editor_input.h"

#include <gmock/gmock.h>

#include "tests/frustum_editor/editor_scene.h"

namespace ocelli {
namespace {

constexpr double kPixelOfPlan = 0.2;  // lengths of the plans below: pointers are whole pixels

class EditorInputTest : public testing::Test {
 protected:
  EditorInputTest() { input.layOut({100, 50}, {300, 500}); }

  glm::dvec2 pointerOf(size_t plan, const glm::dvec2& paper) const {
    return glm::round(input.plans()[plan].corner + input.plans()[plan].window.pixelFromPaper(paper));
  }
  void move(const glm::dvec2& to) { input.handle(PointerMoveEvent{to.x, to.y}, to); }
  void button(bool pressed, const glm::dvec2& at, PointerButton which = PointerButton::kLeft, bool shift = true) {
    input.handle(PointerButtonEvent{which, pressed, {shift, false, false}}, at);
  }
  void stroke(size_t plan, const glm::dvec2& from, const glm::dvec2& to) {
    move(pointerOf(plan, from));
    button(true, pointerOf(plan, from));
    move(pointerOf(plan, to));
    button(false, pointerOf(plan, to));
  }
  bool key(Key key, bool shift = false, bool control = false) {
    return input.handle(KeyEvent{key, true, {shift, control, false}});
  }
  void type(const std::string& keys) {
    for (const char c : keys) {
      key(c == '-'   ? Key::kMinus
          : c == '.' ? Key::kPeriod
          : c == ' ' ? Key::kSpace
                     : *keyFromName(std::string(1, static_cast<char>(std::toupper(c)))));
    }
  }

  test::EditorFixture fixture;
  int saved = 0;
  EditorInput input{fixture.editor, boundsOf(fixture.mesh), [this] { ++saved; }};
  FrustumEditor& editor = fixture.editor;
};

TEST_F(EditorInputTest, plansShareTheArea) {
  EXPECT_EQ(input.plans()[0].window.size, glm::ivec2(300, 300));
  EXPECT_EQ(input.plans()[1].window.size, glm::ivec2(300, 200));
  EXPECT_EQ(input.plans()[1].corner, glm::dvec2(100, 350));
  const double scale = input.plans()[0].window.unitsPerPixel;
  input.layOut({0, 0}, {600, 400});
  EXPECT_EQ(input.plans()[0].window.unitsPerPixel, scale);  // a larger window shows more
}

TEST_F(EditorInputTest, thePointerDraws) {
  key(Key::kB);
  EXPECT_EQ(editor.tool().name, "bend");
  stroke(0, {-6, 2}, {6, 2});
  ASSERT_EQ(editor.message(), "");
  ASSERT_NE(editor.drawn().find("frustum 1"), nullptr);
  EXPECT_NEAR(editor.drawn().find("frustum 1")->begins.middle.z, 2, kPixelOfPlan);
  key(Key::kV);
  stroke(0, {0, 8}, {2, 8.5});  // the viewpoint of the selected frustum, which lies on the eye
  EXPECT_NEAR(editor.drawn().find("frustum 1")->viewpoint.x, 2, kPixelOfPlan);
  stroke(1, {2, -1.5}, {2, -2.5});  // in the side plan, higher
  EXPECT_NEAR(editor.drawn().find("frustum 1")->viewpoint.y, 2.5, kPixelOfPlan);
  EXPECT_EQ(input.active(), 1U);
}

TEST_F(EditorInputTest, theWheelZoomsAndOtherButtonsMoveThePaper) {
  const glm::dvec2 at = pointerOf(0, {3, 3});
  const double scale = input.plans()[0].window.unitsPerPixel;
  EXPECT_TRUE(input.handle(ScrollEvent{0, 1}, at));
  EXPECT_LT(input.plans()[0].window.unitsPerPixel, scale);
  EXPECT_FALSE(input.handle(ScrollEvent{0, 1}, {0, 0}));  // beside the plans
  const std::string text = editor.text();
  move(at);
  button(true, at, PointerButton::kRight);
  move(at + glm::dvec2(10, 0));
  button(false, at + glm::dvec2(10, 0), PointerButton::kRight);
  EXPECT_NEAR(input.plans()[0].window.pixelFromPaper({3, 3}).x + input.plans()[0].corner.x, at.x + 10, 1);
  EXPECT_EQ(editor.text(), text);
}

TEST_F(EditorInputTest, allGoesByKeys) {
  key(Key::kB);
  input.escape();
  // From the middle of the plan 3 units towards the eye: pressed there, it bends across the rays.
  const double step = gridStep(input.plans()[0].window.unitsPerPixel);
  for (double moved = 0; moved < 3; moved += step) {
    key(Key::kDown, true);
  }
  key(Key::kEnter);
  EXPECT_TRUE(editor.isDragging());
  key(Key::kRight, true);
  key(Key::kEnter);
  EXPECT_FALSE(editor.isDragging());
  ASSERT_NE(editor.drawn().find("frustum 1"), nullptr) << editor.message();
  // A name.
  key(Key::kF2);
  ASSERT_TRUE(input.entry());
  type("my street2");
  key(Key::kBackspace);
  key(Key::kEnter);
  EXPECT_NE(editor.drawn().find("my street"), nullptr) << editor.message();
  // A handle, and its numbers.
  key(Key::kV);
  while (!editor.selectedHandle(PlanSide::kTop) || editor.selectedHandle(PlanSide::kTop)->kind->name != "viewpoint") {
    ASSERT_TRUE(key(Key::kTab));
  }
  EXPECT_EQ(input.chosenNumber(), "x");
  type("-1.5");
  ASSERT_TRUE(input.entry());
  EXPECT_EQ(input.entry()->text, "-1.5");
  key(Key::kEnter);
  EXPECT_EQ(editor.drawn().find("my street")->viewpoint.x, -1.5) << editor.message();
  key(Key::kN);
  EXPECT_EQ(input.chosenNumber(), "y");
  type("2");
  key(Key::kEscape);
  EXPECT_FALSE(input.entry());
  EXPECT_EQ(editor.drawn().find("my street")->viewpoint.y, 1.5);
  key(Key::kLeft, true);
  EXPECT_NEAR(editor.drawn().find("my street")->viewpoint.x, -1.5 - step, 1e-9);
  key(Key::kZ, false, true);
  EXPECT_EQ(editor.drawn().find("my street")->viewpoint.x, -1.5);
  key(Key::kY, false, true);
  EXPECT_NEAR(editor.drawn().find("my street")->viewpoint.x, -1.5 - step, 1e-9);
  key(Key::kO);
  EXPECT_TRUE(editor.drawn().overlapAllowed);
  key(Key::kDelete);
  EXPECT_EQ(editor.drawn().frusta.size(), 1U);
  key(Key::kS, false, true);
  EXPECT_EQ(saved, 1);
}

TEST_F(EditorInputTest, whatIsNoNumberStaysToBeCorrected) {
  key(Key::kTab);
  type("1..5");
  key(Key::kEnter);
  ASSERT_TRUE(input.entry());
  EXPECT_EQ(input.entry()->text, "1..5");
}

TEST_F(EditorInputTest, theSidePlanTurns) {
  key(Key::kP);
  EXPECT_EQ(input.active(), 1U);
  EXPECT_EQ(input.plans()[1].window.side, PlanSide::kFront);
  key(Key::kF);
  EXPECT_EQ(input.plans()[1].window.side, PlanSide::kRight);
  const double scale = input.plans()[1].window.unitsPerPixel;
  key(Key::kEqual);
  EXPECT_LT(input.plans()[1].window.unitsPerPixel, scale);
}

TEST(EditorKeys, eachKeyDoesOneThing) {
  std::set<std::pair<Key, bool>> seen;
  for (const EditorKey& row : editorKeys()) {
    if (row.act != nullptr) {
      EXPECT_TRUE(seen.insert({row.key, row.control}).second) << row.keys << " " << nameOf(row.key);
    }
  }
  for (const EditorTool& tool : editorTools()) {
    EXPECT_TRUE(seen.contains({*keyFromName(std::string(1, tool.key)), false})) << tool.name;
  }
}

}  // namespace
}  // namespace ocelli
