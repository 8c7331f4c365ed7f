#include "oc_core/explore_window/draw_pane.h"

#include <gtest/gtest.h>

#include "oc_core/explore_window/explore_window.h"
#include "oc_core/explore_window/explorer_window_model.h"
#include "oc_core/frustum_editor/editor_input.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

std::shared_ptr<ExploreScene> smallMaze() {
  SceneOptions options;
  options.fit = false;
  return std::make_shared<ExploreScene>(loadGuidedScene("builtin:maze,columns=3,rows=3", options));
}

class DrawPaneTest : public testing::TestWithParam<GlProvider> {
 protected:
  void SetUp() override {
    window.handle(ResizeEvent{1280, 720, 1, 1});
    frames(2);
    key(Key::kG);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      window.update(1.0 / 30);
      window.draw();
    }
  }
  void key(Key key, Modifiers modifiers = {}) {
    window.handle(KeyEvent{key, true, modifiers});
    window.handle(KeyEvent{key, false, modifiers});
    frames(2);
  }
  ExploreWindowLayout::Pane pane() const { return window.layout().panes.back(); }

  /// On the screen, of a point that is so far ahead of the walker and to its right, in the plan from above.
  glm::vec2 screenPoint(float ahead, float right) {
    const WindowPlan& plan = window.picture()->plan;
    const glm::vec2 paper = plan.walker + plan.heading * ahead + glm::vec2(-plan.heading.y, plan.heading.x) * right;
    // The same layout as that of the pane: two lines of words are below the plans.
    const PinholeCamera& root = *window.picture()->pinholeCamera;
    FrustumEditor editor(FrustumEditor::newGraphCamera(root), "a test", root, window.picture()->scene->mesh(),
                         window.picture()->scene->guides());
    EditorInput input(editor, window.picture()->scene->bounds(), [] {});
    const ExplorePaneRect rect = pane().rect;
    input.layOut({rect.x, rect.y}, {static_cast<int>(rect.width), static_cast<int>(rect.height - 52)});
    return glm::vec2(input.plans()[0].corner + input.plans()[0].window.pixelFromPaper(glm::dvec2(paper)));
  }
  void drag(const glm::vec2& from, const glm::vec2& to) {
    window.handle(PointerMoveEvent{from.x, from.y});
    frames(1);
    window.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
    frames(1);
    for (const float share : {0.3f, 0.7f, 1.0f}) {
      const glm::vec2 at = glm::mix(from, to, share);
      window.handle(PointerMoveEvent{at.x, at.y});
      frames(1);
    }
    window.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
    frames(60);  // what was shown before dissolves
  }
  std::string savedCamera(const std::string& name) {
    key(Key::kS, {.control = true});
    return test::fileBytes(folder / name);
  }

  test::TemporaryFolder folder;
  std::unique_ptr<GlContext> context = openTestContext(GetParam());
  ExploreWindow window{*context,
                       {.make = makeExplorerModel({.read = [](const Progress&) { return smallMaze(); }}),
                        .way = ExploreWindowWork::Way::kStepwise,
                        .folder = folder.path(),
                        .showTimes = false}};
};

TEST_P(DrawPaneTest, takesTheRoomAndTheKeys) {
  EXPECT_EQ(window.layout().panes.size(), 2U);
  EXPECT_EQ(window.state().active, "draw");
  key(Key::kW);  // no tool of the editor, and held keys walk
  key(Key::kM);  // a tool here
  EXPECT_FALSE(window.state().shown.contains("plan"));
  key(Key::kF6);
  EXPECT_EQ(window.state().active, "view");
  key(Key::kM);
  EXPECT_TRUE(window.state().shown.contains("plan"));
  key(Key::kG);
  EXPECT_FALSE(window.state().shown.contains("draw"));
}

TEST_P(DrawPaneTest, aStrokeBendsTheRaysInTheView) {
  const std::string before = savedCamera("camera-001.json");
  const Image<Rgb8> view = window.picture()->view;
  key(Key::kB);
  drag(screenPoint(1, -2), screenPoint(1.3f, 2));
  const std::string after = savedCamera("camera-002.json");
  EXPECT_NE(after, before);
  EXPECT_NE(after.find("bend"), std::string::npos) << after;
  const WindowPicture& picture = *window.picture();
  EXPECT_EQ(picture.choices[picture.chosen].name, "drawn");
  if (const char* images = std::getenv("OCELLI_TEST_IMAGES")) {
    writePng(std::filesystem::path(images) / "explore_draw.png", window.screenshot());
  }
  key(Key::kZ, {.control = true});
  EXPECT_EQ(savedCamera("camera-003.json"), before);
}

TEST_P(DrawPaneTest, aFileThatIsDroppedIsDrawnOn) {
  key(Key::kB);
  drag(screenPoint(1, -2), screenPoint(1.3f, 2));
  const std::string drawn = savedCamera("camera-001.json");
  key(Key::kG, {.shift = true});
  EXPECT_NE(savedCamera("camera-002.json"), drawn);
  const glm::vec2 over = screenPoint(1, 0);
  window.handle(PointerMoveEvent{over.x, over.y});
  window.handle(DropEvent{{(folder / "camera-001.json").string()}});
  frames(60);
  EXPECT_EQ(savedCamera("camera-003.json"), drawn);
  // What is no camera leaves it as it was.
  window.handle(DropEvent{{folder.write("other.json", "{}").string()}});
  frames(2);
  EXPECT_EQ(savedCamera("camera-004.json"), drawn);
}

TEST_P(DrawPaneTest, aDragShowsASmallImageFirst) {
  key(Key::kB);
  const glm::vec2 from = screenPoint(1, -2);
  window.handle(PointerMoveEvent{from.x, from.y});
  window.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  const glm::vec2 to = screenPoint(1.3f, 2);
  window.handle(PointerMoveEvent{to.x, to.y});
  frames(60);
  const Image<Rgb8> small = window.picture()->view;
  window.handle(PointerButtonEvent{PointerButton::kLeft, false, {}});
  frames(60);
  EXPECT_EQ(window.picture()->view.width(), small.width());  // it fills the same place
  EXPECT_FALSE(window.picture()->view == small);
}

TEST_P(DrawPaneTest, helpIsThatOfTheEditor) {
  const Image<Rgb8> before = window.screenshot();
  key(Key::kF1);
  EXPECT_TRUE(window.state().help);
  EXPECT_FALSE(window.screenshot() == before);
  EXPECT_FALSE(makeDrawPane()->help().empty());
}

TEST_P(DrawPaneTest, curvedCamerasAreBegunAnew) {
  window.handle(KeyEvent{Key::kF6, true, {}});
  key(Key::kG, {.control = true});
  EXPECT_NE(savedCamera("camera-001.json").find("curved"), std::string::npos);
}

// Camera files take coordinates up to a million.
TEST_P(DrawPaneTest, wherePlansCannotBeginItSaysSoAndCloses) {
  ExploreWindow far(*context, {.make = makeExplorerModel({.read = [](const Progress&) { return smallMaze(); },
                                                          .start = WalkerView{{3e6, 1.6, 0}, 0, 0}}),
                               .way = ExploreWindowWork::Way::kStepwise,
                               .folder = folder.path(),
                               .showTimes = false});
  far.handle(ResizeEvent{640, 360, 1, 1});
  const auto show = [&] {
    far.update(1.0 / 30);
    far.draw();
  };
  show();
  for (int i = 0; i < 2; ++i) {
    far.handle(KeyEvent{Key::kG, true, {}});
    far.handle(KeyEvent{Key::kG, false, {}});
    show();
    EXPECT_FALSE(far.state().shown.contains("draw"));
    EXPECT_EQ(far.state().active, "view");
    EXPECT_TRUE(far.state().messageIsError);
    EXPECT_NE(far.state().message, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Offscreen, DrawPaneTest, kOffscreenProviders, providerName);

}  // namespace
}  // namespace ocelli
