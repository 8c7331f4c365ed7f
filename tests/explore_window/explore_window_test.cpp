#include "oc_core/explore_window/explore_window.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/explore_window/explore_overlays.h"
#include "tests/base/temporary_folder.h"
#include "tests/explore_window/recording_model.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

class ExploreWindowTest : public testing::TestWithParam<GlProvider> {
 protected:
  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 720;

  void SetUp() override {
    window.handle(ResizeEvent{kWidth, kHeight, 1, 1});
    frames(2);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      window.update(1.0 / 30);
      window.draw();
    }
  }
  void key(Key key, Modifiers modifiers = {}) {
    window.handle(KeyEvent{key, true, modifiers});
    frames(1);
    window.handle(KeyEvent{key, false, modifiers});
    frames(2);
  }
  void press(double x, double y, PointerButton button = PointerButton::kLeft) {
    window.handle(PointerMoveEvent{x, y});
    frames(1);
    window.handle(PointerButtonEvent{button, true, {}});
    frames(1);
  }
  void release(PointerButton button = PointerButton::kLeft) {
    window.handle(PointerButtonEvent{button, false, {}});
    frames(1);
  }
  /// OCELLI_TEST_IMAGES=FOLDER keeps what it looks like.
  void keepImage(const std::string& name) {
    if (const char* folderOfImages = std::getenv("OCELLI_TEST_IMAGES")) {
      writePng(std::filesystem::path(folderOfImages) / (name + ".png"), window.screenshot());
    }
  }
  const std::string& lastCall() const { return record.calls.back(); }

  test::TemporaryFolder folder;
  test::ModelRecord record;
  std::unique_ptr<GlContext> context = openTestContext(GetParam());
  ExploreWindow window{*context,
                       {.make = [this](const Progress&) { return test::makeRecordingModel(record); },
                        .way = ExploreWindowWork::Way::kStepwise,
                        .folder = folder.path(),
                        .showTimes = false}};
};

TEST_P(ExploreWindowTest, theViewShowsItsPixelsAsTheyAre) {
  window.state().hintSeconds = 100;
  frames(2);
  const Image<Rgb8> shot = window.screenshot();
  const ExplorePaneRect rect = window.layout().panes.front().rect;
  EXPECT_EQ(record.shape.view, glm::ivec2(rect.width, rect.height));
  for (int y = 0; y < static_cast<int>(rect.height); y += 7) {
    for (int x = 0; x < static_cast<int>(rect.width); x += 13) {
      ASSERT_EQ(shot(x + static_cast<int>(rect.x), y + static_cast<int>(rect.y)), window.picture()->view(x, y))
          << x << " " << y;
    }
  }
}

TEST_P(ExploreWindowTest, keysWalkAsLongAsTheyAreHeld) {
  window.handle(KeyEvent{Key::kW, true, {}});
  window.handle(KeyEvent{Key::kLeft, true, {}});
  frames(1);
  EXPECT_EQ(record.motion.ahead, 1);
  EXPECT_EQ(record.motion.turnRight, -1);
  window.handle(KeyEvent{Key::kS, true, {.shift = true}});
  frames(1);
  EXPECT_EQ(record.motion.ahead, 0);  // both
  EXPECT_TRUE(record.motion.fast);
  window.handle(KeyEvent{Key::kS, false, {}});
  window.handle(KeyEvent{Key::kLeft, false, {}});
  window.handle(KeyEvent{Key::kW, false, {}});
  frames(1);
  EXPECT_EQ(record.motion, WindowMotion());
}

TEST_P(ExploreWindowTest, nothingIsHeldWithoutTheKeyboard) {
  window.handle(KeyEvent{Key::kW, true, {}});
  window.state().captured = true;
  GamepadState pad;
  pad.axes[0] = 1;
  window.handleGamepad(pad);
  frames(1);
  EXPECT_EQ(record.motion.right, 1);
  window.loseFocus();
  frames(1);
  EXPECT_EQ(record.motion, WindowMotion());
  EXPECT_FALSE(window.state().captured);
}

TEST_P(ExploreWindowTest, aDragEndsWithoutTheFocus) {
  press(300, 300);
  window.loseFocus();
  // The button is let go elsewhere; what comes back is a pointer without it.
  window.handle(PointerMoveEvent{500, 300});
  frames(1);
  EXPECT_EQ(record.turned, glm::vec2(0));
  release();
  EXPECT_TRUE(record.calls.empty());
}

TEST_P(ExploreWindowTest, whatCannotBeSavedLeavesNoFile) {
  // The name of what is written first is a folder, so that no file can be.
  std::filesystem::create_directories(folder / "explore-001.png.partial" / "in the way");
  key(Key::kP);
  EXPECT_TRUE(window.state().messageIsError) << window.state().message;
  EXPECT_FALSE(std::filesystem::exists(folder / "explore-001.png"));
}

TEST_P(ExploreWindowTest, aDragLooksAroundAndAClickPicks) {
  const ExplorePaneRect view = window.layout().panes.front().rect;
  press(300, 300);
  window.handle(PointerMoveEvent{300 + view.width / 9, 300});
  frames(1);
  EXPECT_NEAR(record.turned.x, -10, 1e-3f);  // 90 degrees over the width; what is seen follows the pointer
  release();
  EXPECT_TRUE(record.calls.empty());
  press(300, 300);
  release();
  EXPECT_EQ(lastCall(), "pick 300 260");  // the bar above takes 40
}

TEST_P(ExploreWindowTest, aCapturedMouseTurnsAndPicksTheMiddle) {
  press(200, 200, PointerButton::kRight);
  release(PointerButton::kRight);
  EXPECT_TRUE(window.state().captured);
  window.handle(PointerMoveEvent{5000, -100});  // where the system has put it says nothing
  frames(1);
  const glm::vec2 before = record.turned;
  window.handle(PointerMoveEvent{5100, -150});
  frames(1);
  EXPECT_NEAR(record.turned.x - before.x, 12, 1e-3f);
  EXPECT_NEAR(record.turned.y - before.y, 6, 1e-3f);
  window.handle(PointerButtonEvent{PointerButton::kLeft, true, {}});
  frames(1);
  const ExplorePaneRect view = window.layout().panes.front().rect;
  EXPECT_EQ(lastCall(),
            "pick " + std::to_string(std::lround(view.width / 2)) + " " + std::to_string(std::lround(view.height / 2)));
  key(Key::kEscape);
  EXPECT_FALSE(window.state().captured);
}

TEST_P(ExploreWindowTest, aClickInThePlanGoesThere) {
  const ExploreWindowLayout::Pane plan = window.layout().panes.back();
  press(plan.rect.x + plan.rect.width / 2, plan.rect.y + plan.rect.height / 2);
  release();
  EXPECT_EQ(lastCall(), "go to 0 0");  // 10 units around the walker, which is all that there is
}

TEST_P(ExploreWindowTest, camerasAreChosenByTheirButtons) {
  // Buttons are as wide as their texts: the first ends before this.
  for (int x = 20; x < 500 && record.calls.empty(); x += 10) {
    press(x, 20);
    release();
    if (!record.calls.empty() && lastCall() == "choose 0") {
      record.calls.clear();
    }
  }
  ASSERT_FALSE(record.calls.empty());
  EXPECT_EQ(lastCall(), "choose 1");
}

TEST_P(ExploreWindowTest, panesAskForTheirImages) {
  EXPECT_FALSE(record.shape.pinhole);
  EXPECT_TRUE(record.shape.ground);
  key(Key::kTab);
  ASSERT_TRUE(record.shape.pinhole);
  const ExploreWindowLayout::Pane pane = window.layout().panes[1];
  EXPECT_EQ(*record.shape.pinhole, glm::ivec2(pane.rect.width, pane.rect.height));
  const Image<Rgb8> shot = window.screenshot();
  EXPECT_EQ(shot(static_cast<int>(pane.rect.x) + 5, static_cast<int>(pane.rect.y) + 5), (Rgb8{20, 120, 150}));
  key(Key::kM);
  EXPECT_FALSE(record.shape.ground);
  key(Key::kTab);
  EXPECT_EQ(window.layout().panes.size(), 1U);
}

TEST_P(ExploreWindowTest, bordersAreThereAndCanBeOff) {
  window.state().hintSeconds = 100;
  key(Key::k2);
  frames(1);
  const Image<Rgb8> with = window.screenshot();
  keepImage("explore_borders");
  const ExplorePaneRect rect = window.layout().panes.front().rect;
  // Across the left side of the bend of the model, in its middle: a line of two pixels covers one at least by half.
  const auto y = static_cast<int>(rect.y + 0.4f * rect.height);
  const auto middle = static_cast<int>(rect.x + 0.6f * rect.width);
  const auto nearest = [&](const Image<Rgb8>& image) {
    int least = 765;
    for (int x = middle - 3; x <= middle + 3; ++x) {
      const glm::ivec3 difference = glm::abs(glm::ivec3(image(x, y)) - glm::ivec3(230, 159, 0));
      least = std::min(least, difference.x + difference.y + difference.z);
    }
    return least;
  };
  EXPECT_LT(nearest(with), 180);  // half of the way to the colour below, (60, 120, 150), is 180
  key(Key::kB);
  EXPECT_EQ(nearest(window.screenshot()), 170 + 39 + 150);
}

TEST_P(ExploreWindowTest, helpCoversTheWindowAndGoes) {
  const Image<Rgb8> before = window.screenshot();
  key(Key::kH);
  EXPECT_TRUE(window.state().help);
  EXPECT_FALSE(window.screenshot() == before);
  keepImage("explore_help");
  press(400, 400);
  release();
  EXPECT_TRUE(record.calls.empty());  // what lies below is not clicked
  key(Key::kEscape);
  EXPECT_FALSE(window.state().help);
}

TEST_P(ExploreWindowTest, anErrorStaysUntilEscape) {
  key(Key::k2);
  window.work().tell([](ExploreWindowModel& model) {
    model.setField("amount", 1000);
    return std::string();
  });
  frames(300);
  EXPECT_TRUE(window.state().messageIsError);
  keepImage("explore_error");
  key(Key::kEscape);
  EXPECT_TRUE(window.state().message.empty());
}

TEST_P(ExploreWindowTest, imagesAndCamerasAreSavedUnderNewNames) {
  key(Key::kP);
  key(Key::kP);
  key(Key::kK);
  EXPECT_TRUE(std::filesystem::exists(folder / "explore-001.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "explore-002.png"));
  EXPECT_EQ(test::fileBytes(folder / "camera-001.json"), "{}\n");
  EXPECT_NE(window.state().message.find("camera-001.json"), std::string::npos);
}

TEST_P(ExploreWindowTest, everySizeAndScaleIsDrawn) {
  key(Key::k2);
  key(Key::kTab);
  key(Key::kO);
  for (const ResizeEvent& size : {ResizeEvent{640, 360, 1, 1}, ResizeEvent{2560, 1440, 1, 2},
                                  ResizeEvent{1280, 720, 2, 2}, ResizeEvent{40, 30, 1, 1}, ResizeEvent{0, 0, 1, 1}}) {
    window.handle(size);
    frames(3);
    EXPECT_EQ(window.target().width(), std::max(1, static_cast<int>(size.width * size.pixelsPerUnit)));
    EXPECT_EQ(window.target().height(), std::max(1, static_cast<int>(size.height * size.pixelsPerUnit)));
    keepImage("explore_" + std::to_string(size.width) + "_" + std::to_string(static_cast<int>(size.contentScale)));
  }
}

TEST_P(ExploreWindowTest, aGamepadPressesTheSameKeys) {
  GamepadState pad;
  pad.buttons[7] = true;
  window.handleGamepad(pad);
  EXPECT_TRUE(window.state().help);
  pad = {};
  pad.buttons[5] = true;
  window.handleGamepad(pad);
  frames(1);
  EXPECT_EQ(lastCall(), "choose 1");
}

TEST_P(ExploreWindowTest, theSameEventsGiveTheSamePixels) {
  test::ModelRecord otherRecord;
  ExploreWindow other(*context, {.make = [&](const Progress&) { return test::makeRecordingModel(otherRecord); },
                                 .way = ExploreWindowWork::Way::kStepwise,
                                 .folder = folder.path(),
                                 .showTimes = false});
  other.handle(ResizeEvent{kWidth, kHeight, 1, 1});
  const auto play = [](ExploreWindow& to) {
    to.handle(KeyEvent{Key::k2, true, {}});
    to.handle(KeyEvent{Key::kW, true, {}});
    for (int i = 0; i < 10; ++i) {
      to.update(1.0 / 30);
      to.draw();
    }
  };
  other.update(1.0 / 30);
  other.draw();
  other.update(1.0 / 30);
  other.draw();
  play(window);
  play(other);
  EXPECT_TRUE(window.screenshot() == other.screenshot());
}

TEST_P(ExploreWindowTest, aFileThatIsDroppedIsOpened) {
  window.handle(DropEvent{{"camera.json", "other.json"}});
  frames(1);
  EXPECT_EQ(lastCall(), "open camera.json");
}

TEST_P(ExploreWindowTest, whatAsksToCloseIsHeard) {
  EXPECT_FALSE(window.wantsClose());
  key(Key::kQ, {.control = true});
  EXPECT_TRUE(window.wantsClose());
}

TEST(ExploreHint, fadesAndIsGone) {
  EXPECT_EQ(exploreHintOpacity(0), 1);
  EXPECT_EQ(exploreHintOpacity(9), 1);
  EXPECT_NEAR(exploreHintOpacity(9.75), 0.5, 1e-6);
  EXPECT_EQ(exploreHintOpacity(11), 0);
}

INSTANTIATE_TEST_SUITE_P(Offscreen, ExploreWindowTest, kOffscreenProviders, providerName);

}  // namespace
}  // namespace ocelli
