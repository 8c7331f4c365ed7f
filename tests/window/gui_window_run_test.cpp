// runGuiWindow() on a (virtual) screen.
#include "oc_core/window/gui_window_run.h"

#include <gmock/gmock.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <thread>

#include "tests/window/counting_window.h"
#include "tests/window/x_server.h"

namespace ocelli {
namespace {

class GuiWindowRunTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) {
      GTEST_SKIP() << "there is no display: install xvfb and xauth, and configure again";
    }
    window_.emplace(GlWindowOptions{.title = "test", .width = 300, .height = 200, .debug = GlDebug::kErrorsAreFatal});
    shown_.emplace(window_->context());
  }

  /// Returns how long that took, seconds.
  double runTurns(int turns) {
    const auto start = std::chrono::steady_clock::now();
    runGuiWindow(*window_, *shown_, [&] { return --turns >= 0; });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::optional<GlWindow> window_;
  std::optional<test::CountingWindow> shown_;
};

TEST_F(GuiWindowRunTest, showsWhatIsDrawn) {
  test::XServer server;
  std::array<uint8_t, 3> seen{};
  const std::array<uint8_t, 3> expected{kGuiAccent.red, kGuiAccent.green, kGuiAccent.blue};
  shown_->isMoving = true;
  for (int i = 0; i < 50 && seen != expected; ++i) {  // the X server shows it some time later
    runTurns(3);
    int left = 0;
    int top = 0;
    glfwGetWindowPos(window_->handle(), &left, &top);
    seen = server.screenPixel(left + 150, top + 10);
  }
  EXPECT_EQ(seen, expected);
}

TEST_F(GuiWindowRunTest, drawsWhatChangesAndMoreOftenWhileItMoves) {
  constexpr int kTurns = 12;
  runTurns(kTurns);  // with the events of opening
  shown_->draws = 0;
  const double resting = runTurns(kTurns);
  EXPECT_LT(shown_->draws, kTurns / 2) << "nothing moves";
  EXPECT_GE(resting, 0.5) << "ten turns a second";
  shown_->isMoving = true;
  shown_->draws = 0;
  const double moving = runTurns(kTurns);
  EXPECT_EQ(shown_->draws, kTurns);
  EXPECT_LT(moving, resting);
}

TEST_F(GuiWindowRunTest, tellsTheTimeThatHasPassed) {
  const auto start = std::chrono::steady_clock::now();
  int turns = 3;
  runGuiWindow(*window_, *shown_, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return --turns >= 0;
  });
  EXPECT_GE(shown_->advanced, 0.3);
  EXPECT_LE(shown_->advanced, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

TEST_F(GuiWindowRunTest, fillsTheScreenAndComesBack) {
  for (const bool filled : {true, false}) {
    shown_->state().wantsFullscreen = true;
    runTurns(2);
    EXPECT_EQ(window_->isFullscreen(), filled);
  }
}

// As GLFW calls it, since a screen without a window manager takes no focus away.
TEST_F(GuiWindowRunTest, tellsOfALostFocus) {
  runTurns(5);
  shown_->lostFocus = 0;
  const GLFWwindowfocusfun focus = glfwSetWindowFocusCallback(window_->handle(), nullptr);
  glfwSetWindowFocusCallback(window_->handle(), focus);
  focus(window_->handle(), GLFW_TRUE);
  runTurns(1);
  EXPECT_EQ(shown_->lostFocus, 0);
  focus(window_->handle(), GLFW_FALSE);
  runTurns(1);
  EXPECT_EQ(shown_->lostFocus, 1);
}

TEST_F(GuiWindowRunTest, endsWhereTheUserClosesIt) {
  const GLFWwindowclosefun close = glfwSetWindowCloseCallback(window_->handle(), nullptr);
  glfwSetWindowCloseCallback(window_->handle(), close);
  int turns = 0;
  runGuiWindow(*window_, *shown_, [&] {
    if (++turns == 3) {
      close(window_->handle());
    }
    return turns < 100;
  });
  EXPECT_EQ(turns, 3) << "and not because it was told to";
  EXPECT_TRUE(shown_->wantsClose());
}

TEST_F(GuiWindowRunTest, passesErrorsOn) {
  shown_->failsToPaint = true;
  EXPECT_THROW(runTurns(5), std::domain_error);
}

}  // namespace
}  // namespace ocelli
