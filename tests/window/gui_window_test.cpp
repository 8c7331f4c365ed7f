#include "oc_core/window/gui_window.h"

#include <gmock/gmock.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "oc_core/gl/gl_api.h"
#include "tests/gl/gl_test_context.h"
#include "tests/window/counting_window.h"

namespace ocelli {
namespace {

Rgb8 valueOf(GuiColor color) {
  return {color.red, color.green, color.blue};
}

class GuiWindowTest : public testing::TestWithParam<GlProvider> {
 protected:
  GuiWindowTest() { window_.emplace(*context_); }

  /// Draws until nothing waits any more, as on a screen. Returns how often.
  int drawUntilDone() {
    int times = 0;
    for (; window_->needsDrawing() && times < 100; ++times) {
      window_->draw();
    }
    return times;
  }
  void expectPicture(int width, int height) {
    const Image<Rgb8> image = window_->screenshot();
    ASSERT_EQ(image.width(), width);
    ASSERT_EQ(image.height(), height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const GuiColor expected = y < height / 2 ? kGuiAccent : x < width / 2 ? kGuiField : kGuiBackground;
        ASSERT_EQ(image(x, y), valueOf(expected)) << x << " " << y;
      }
    }
  }

  std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
  std::optional<test::CountingWindow> window_;
};
INSTANTIATE_TEST_SUITE_P(Providers, GuiWindowTest, kOffscreenProviders, providerName);

TEST_P(GuiWindowTest, drawsTheBackgroundWhatIsPaintedAndThePanels) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->draw();
  expectPicture(60, 40);
}

TEST_P(GuiWindowTest, hasThePixelsOfTheWindow) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->draw();
  window_->handle(ResizeEvent{70, 30, 2, 2});
  window_->draw();
  expectPicture(140, 60);
  window_->handle(ResizeEvent{101, 41, 1.25, 1.25});  // 126.25 and 51.25
  window_->draw();
  EXPECT_EQ(window_->target().width(), 126);
  EXPECT_EQ(window_->target().height(), 51);
}

TEST_P(GuiWindowTest, isDrawnWhenSomethingChanged) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  EXPECT_TRUE(window_->needsDrawing());
  drawUntilDone();
  window_->update(1);
  EXPECT_FALSE(window_->needsDrawing()) << "time alone changes nothing";
  window_->handle(PointerMoveEvent{3, 4});
  EXPECT_TRUE(window_->needsDrawing());
  drawUntilDone();
  window_->isMoving = true;
  window_->update(1);
  EXPECT_TRUE(window_->needsDrawing());
}

TEST_P(GuiWindowTest, isDrawnUntilThePanelsHaveSeenAllEvents) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  drawUntilDone();
  for (const bool pressed : {true, false, true, false}) {
    window_->handle(PointerButtonEvent{PointerButton::kLeft, pressed, {}});
  }
  EXPECT_GE(drawUntilDone(), 4) << "a frame sees one state of a button";
  EXPECT_FALSE(window_->needsDrawing());
}

TEST_P(GuiWindowTest, withoutPixelsThereIsNothingToDraw) {
  EXPECT_FALSE(window_->needsDrawing()) << "before it has a size";
  window_->draw();
  for (const ResizeEvent& none : {ResizeEvent{0, 0, 1, 1}, ResizeEvent{60, 0, 1, 1}, ResizeEvent{0, 40, 1, 1}}) {
    window_->handle(none);
    EXPECT_FALSE(window_->needsDrawing());
    window_->draw();
  }
  EXPECT_EQ(window_->draws, 0);
  window_->handle(ResizeEvent{60, 40, 1, 1});
  EXPECT_TRUE(window_->needsDrawing());
  window_->draw();
  expectPicture(60, 40);
}

TEST_P(GuiWindowTest, closesUnlessItObjects) {
  window_->staysOpen = true;
  window_->handle(CloseEvent());
  window_->handle(PointerMoveEvent{3, 4});
  EXPECT_FALSE(window_->wantsClose());
  EXPECT_EQ(window_->askedToClose, 1) << "once for each wish";
  window_->staysOpen = false;
  window_->handle(CloseEvent());
  EXPECT_TRUE(window_->wantsClose());
}

TEST_P(GuiWindowTest, escapeClosesTheHelpAndThenTheWindow) {
  window_->state().hasHelp = true;
  window_->handle(KeyEvent{Key::kEscape, true, {}});
  EXPECT_FALSE(window_->state().hasHelp);
  EXPECT_FALSE(window_->wantsClose());
  window_->handle(KeyEvent{Key::kEscape, true, {}});
  EXPECT_TRUE(window_->wantsClose());
}

TEST_P(GuiWindowTest, eachWishToFillTheScreenIsTakenOnce) {
  EXPECT_FALSE(window_->takeFullscreenWish());
  window_->state().wantsFullscreen = true;
  EXPECT_TRUE(window_->takeFullscreenWish());
  EXPECT_FALSE(window_->takeFullscreenWish());
}

TEST_P(GuiWindowTest, takesEveryEvent) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->handle(ScrollEvent{0, 2});
  window_->handle(CloseEvent());
  ASSERT_EQ(window_->taken.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<ResizeEvent>(window_->taken[0]));
  EXPECT_TRUE(std::holds_alternative<ScrollEvent>(window_->taken[1]));
  EXPECT_TRUE(std::holds_alternative<CloseEvent>(window_->taken[2]));
}

TEST_P(GuiWindowTest, panelsKnowTheTimeSinceTheLastDraw) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->draw();
  window_->update(0.25);
  window_->update(0.5);
  window_->draw();
  EXPECT_EQ(window_->frameSeconds, 0.75);
  EXPECT_EQ(window_->advanced, 0.75);
  window_->update(0.125);
  window_->draw();
  EXPECT_EQ(window_->frameSeconds, 0.125);
}

TEST_P(GuiWindowTest, drawsAgainAfterAnErrorWhilePainting) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->failsToPaint = true;
  EXPECT_THROW(window_->draw(), std::domain_error);
  window_->failsToPaint = false;
  window_->draw();
  expectPicture(60, 40);
}

TEST_P(GuiWindowTest, drawsTheSameWhateverOthersHaveLeft) {
  {
    const GlScope scope(*context_);
    context_->gl().Enable(GL_SCISSOR_TEST);
    context_->gl().Scissor(0, 0, 1, 1);
    context_->gl().Enable(GL_DEPTH_TEST);
    context_->gl().ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->draw();
  expectPicture(60, 40);
}

TEST_P(GuiWindowTest, leavesNoObject) {
  window_->handle(ResizeEvent{60, 40, 1, 1});
  window_->draw();
  EXPECT_GT(context_->liveObjects(), 0);
  window_.reset();  // without a GlScope
  EXPECT_EQ(context_->liveObjects(), 0);
  const GlScope scope(*context_);
  context_->check("freeing the window");
}

}  // namespace
}  // namespace ocelli
