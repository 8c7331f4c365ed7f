// Runs on a virtual screen (xvfb-run), where CMake found one.
#include "oc_core/window/gl_window.h"

#include <gmock/gmock.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include "oc_core/gl/gl_api.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/monitors.h"
#include "tests/gl/gl_test_context.h"
#include "tests/window/x_server.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;
using Rgb = std::array<uint8_t, 3>;
constexpr const char* kNoDisplay = "there is no display: install xvfb and xauth, and configure again";
constexpr double kPatience = 5;  // seconds that a busy X server may take; a working one needs milliseconds

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The events until one is as wanted; fails the test where none comes.
std::vector<InputEvent> pollUntil(GlWindow& window, const std::function<bool(const InputEvent&)>& wanted) {
  std::vector<InputEvent> all;
  for (const auto start = Clock::now(); secondsSince(start) < kPatience;) {
    const std::vector<InputEvent> events = window.poll(0.05);
    all.insert(all.end(), events.begin(), events.end());
    if (std::ranges::any_of(events, wanted)) {
      return all;
    }
  }
  ADD_FAILURE() << "the event never came";
  return all;
}

template <class Event>
std::vector<Event> only(const std::vector<InputEvent>& events) {
  std::vector<Event> found;
  for (const InputEvent& event : events) {
    if (const auto* one = std::get_if<Event>(&event)) {
      found.push_back(*one);
    }
  }
  return found;
}

/// The first event that is as wanted.
template <class Event>
Event await(GlWindow& window, const std::function<bool(const Event&)>& wanted) {
  const auto isWanted = [&](const InputEvent& event) {
    const auto* one = std::get_if<Event>(&event);
    return one != nullptr && wanted(*one);
  };
  const std::vector<InputEvent> events = pollUntil(window, isWanted);
  const auto found = std::ranges::find_if(events, isWanted);
  return found != events.end() ? std::get<Event>(*found) : Event{};
}

class GlWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) {
      GTEST_SKIP() << kNoDisplay;
    }
    window_.emplace(GlWindowOptions{
        .title = "test", .width = 300, .height = 200, .visible = true, .debug = GlDebug::kErrorsAreFatal});
  }

  /// Shows an image of the window's size whose quarters have four colours, the first at the top left.
  void showQuarters() {
    const int width = window_->pixelWidth();
    const int height = window_->pixelHeight();
    const GlScope scope(window_->context());
    std::vector<uint8_t> bytes;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Rgb& color = kQuarters[(y < height / 2 ? 0U : 2U) + (x < width / 2 ? 0U : 1U)];
        bytes.insert(bytes.end(), {color[0], color[1], color[2], 255});
      }
    }
    const GlObject color = makeTexture(window_->context(), GL_RGBA8, width, height);
    window_->context().gl().TextureSubImage2D(color.id(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                                              bytes.data());
    const GlObject framebuffer = makeFramebuffer(window_->context(), std::array{color.id()}, 0);
    window_->show(framebuffer, width, height);
  }

  /// Whether the screen comes to show the quarters where the window is.
  void expectQuartersOnScreen(test::XServer& server) {
    int left = 0;
    int top = 0;
    glfwGetWindowPos(window_->handle(), &left, &top);
    const int width = window_->pixelWidth();
    const int height = window_->pixelHeight();
    std::vector<Rgb> seen;
    for (const auto start = Clock::now(); secondsSince(start) < kPatience;) {
      seen.clear();
      for (const int y : {1, height - 2}) {
        for (const int x : {1, width - 2}) {
          seen.push_back(server.screenPixel(left + x, top + y));
        }
      }
      if (std::ranges::equal(seen, kQuarters)) {
        return;
      }
      showQuarters();
      window_->poll(0.02);
    }
    EXPECT_THAT(seen, testing::ElementsAreArray(kQuarters));
  }

  static constexpr std::array<Rgb, 4> kQuarters{{{200, 10, 20}, {30, 180, 40}, {50, 60, 160}, {140, 150, 160}}};
  std::optional<GlWindow> window_;
};

TEST_F(GlWindowTest, opensWithOpenGl45) {
  EXPECT_EQ(window_->context().info().provider, GlProvider::kWindow);
  EXPECT_GE(std::stod(window_->context().info().version), 4.5);
  const auto events = window_->poll();
  ASSERT_FALSE(events.empty());
  const auto* size = std::get_if<ResizeEvent>(&events.front());
  ASSERT_NE(size, nullptr);
  EXPECT_EQ(size->width, 300 * size->contentScale);
  EXPECT_EQ(size->width * size->pixelsPerUnit, window_->pixelWidth());
}

TEST_F(GlWindowTest, showsRowZeroAtTheTop) {
  test::XServer server;
  showQuarters();
  expectQuartersOnScreen(server);
}

TEST_F(GlWindowTest, stretchesAImageOfAnotherSize) {
  test::XServer server;
  const GlScope scope(window_->context());
  const GlObject color = makeTexture(window_->context(), GL_RGBA8, 2, 2);
  const std::array<uint8_t, 16> bytes{9, 8, 7, 255, 9, 8, 7, 255, 9, 8, 7, 255, 9, 8, 7, 255};
  window_->context().gl().TextureSubImage2D(color.id(), 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  const GlObject framebuffer = makeFramebuffer(window_->context(), std::array{color.id()}, 0);
  int left = 0;
  int top = 0;
  glfwGetWindowPos(window_->handle(), &left, &top);
  Rgb last{};
  for (const auto start = Clock::now(); secondsSince(start) < kPatience && last != Rgb{9, 8, 7};) {
    window_->poll(0.02);
    window_->show(framebuffer, 2, 2);
    last = server.screenPixel(left + 298, top + 198);
  }
  EXPECT_EQ(last, (Rgb{9, 8, 7}));
}

TEST_F(GlWindowTest, tellsWhatAPersonDoes) {
  test::XServer server;
  showQuarters();
  int left = 0;
  int top = 0;
  glfwGetWindowPos(window_->handle(), &left, &top);
  glfwFocusWindow(window_->handle());
  server.movePointer(left + 40, top + 30);
  const auto moved =
      await<PointerMoveEvent>(*window_, [](const PointerMoveEvent& event) { return event.x == 40 && event.y == 30; });
  EXPECT_EQ(moved.x, 40);

  server.pressButton(3, true);
  const auto pressed =
      await<PointerButtonEvent>(*window_, [](const PointerButtonEvent& event) { return event.pressed; });
  EXPECT_EQ(pressed.button, PointerButton::kRight);
  server.pressButton(3, false);
  await<PointerButtonEvent>(*window_, [](const PointerButtonEvent& event) { return !event.pressed; });

  server.pressButton(4, true);
  server.pressButton(4, false);
  EXPECT_EQ(await<ScrollEvent>(*window_, [](const ScrollEvent& event) { return event.up != 0; }).up, 1);
  server.pressButton(7, true);
  server.pressButton(7, false);
  EXPECT_EQ(await<ScrollEvent>(*window_, [](const ScrollEvent& event) { return event.right != 0; }).right, 1);

  constexpr unsigned long kShift = 0xFFE1;
  server.pressKey(kShift, true);
  server.pressKey('a', true);
  server.pressKey('a', false);
  server.pressKey(kShift, false);
  const auto events = pollUntil(*window_, [](const InputEvent& event) {
    const auto* key = std::get_if<KeyEvent>(&event);
    return key != nullptr && !key->pressed;
  });
  const auto keys = only<KeyEvent>(events);
  ASSERT_EQ(keys.size(), 2);
  EXPECT_EQ(keys[0].key, Key::kA);
  EXPECT_TRUE(keys[0].pressed);
  EXPECT_TRUE(keys[0].modifiers.shift);
  EXPECT_FALSE(keys[0].modifiers.control);
  const auto texts = only<TextEvent>(events);
  ASSERT_EQ(texts.size(), 1);
  EXPECT_EQ(texts[0].character, U'A');
}

// What no test can do on a screen without a window manager: GLFW's callbacks are called as GLFW calls them.
TEST_F(GlWindowTest, tellsOfFilesDroppedAndTheWishToClose) {
  window_->poll();
  const GLFWdropfun drop = glfwSetDropCallback(window_->handle(), nullptr);
  std::array<const char*, 2> paths{"/tmp/a bunny.ply", "/tmp/ü.obj"};
  drop(window_->handle(), 2, paths.data());
  const GLFWwindowclosefun close = glfwSetWindowCloseCallback(window_->handle(), nullptr);
  glfwSetWindowShouldClose(window_->handle(), GLFW_TRUE);
  close(window_->handle());
  const auto events = window_->poll();
  const auto drops = only<DropEvent>(events);
  ASSERT_EQ(drops.size(), 1);
  EXPECT_THAT(drops[0].files, testing::ElementsAre("/tmp/a bunny.ply", "/tmp/ü.obj"));
  EXPECT_EQ(only<CloseEvent>(events).size(), 1);
  EXPECT_EQ(glfwWindowShouldClose(window_->handle()), GLFW_FALSE);
  EXPECT_TRUE(only<CloseEvent>(window_->poll()).empty());
}

TEST_F(GlWindowTest, followsItsSize) {
  test::XServer server;
  window_->poll();
  glfwSetWindowSize(window_->handle(), 410, 230);
  const auto size = await<ResizeEvent>(*window_, [](const ResizeEvent& event) { return event.width == 410; });
  EXPECT_EQ(size.height, 230);
  EXPECT_EQ(window_->pixelWidth(), 410);
  showQuarters();
  expectQuartersOnScreen(server);
}

TEST_F(GlWindowTest, fillsTheScreenAndComesBack) {
  test::XServer server;
  window_->poll();
  EXPECT_FALSE(window_->isFullscreen());
  window_->setFullscreen(false);  // is that already
  const GLFWvidmode mode = *glfwGetVideoMode(glfwGetPrimaryMonitor());
  window_->setFullscreen(true);
  EXPECT_TRUE(window_->isFullscreen());
  await<ResizeEvent>(*window_, [&](const ResizeEvent& event) { return event.width == mode.width; });
  EXPECT_EQ(window_->pixelHeight(), mode.height);
  showQuarters();
  expectQuartersOnScreen(server);
  window_->setFullscreen(false);
  await<ResizeEvent>(*window_, [](const ResizeEvent& event) { return event.width == 300; });
  EXPECT_FALSE(window_->isFullscreen());
  EXPECT_EQ(window_->size().height, 200);
}

TEST_F(GlWindowTest, fillsAChosenMonitor) {
  window_.reset();
  const std::vector<Monitor> monitors = listMonitors();
  ASSERT_FALSE(monitors.empty());
  GlWindow window({.title = "full", .monitor = 0, .debug = GlDebug::kErrorsAreFatal});
  EXPECT_TRUE(window.isFullscreen());
  EXPECT_EQ(window.pixelWidth(), monitors[0].width);
  EXPECT_EQ(window.pixelHeight(), monitors[0].height);
}

TEST_F(GlWindowTest, refusesAMonitorThatIsNotThere) {
  for (const int monitor : {-1, 99}) {
    EXPECT_THROW(GlWindow({.monitor = monitor}), InputError);
  }
}

TEST_F(GlWindowTest, tellsOfALostMonitor) {
  window_.reset();
  GlWindow window({.title = "full", .monitor = 0, .debug = GlDebug::kErrorsAreFatal});
  window.pollTimed(0);
  // As GLFW calls it, since no test can pull a plug.
  const GLFWmonitorfun changed = glfwSetMonitorCallback(nullptr);
  changed(glfwGetPrimaryMonitor(), GLFW_DISCONNECTED);
  const std::vector<TimedWindowEvent> events = window.pollTimed(0);
  EXPECT_TRUE(std::ranges::any_of(
      events, [](const TimedWindowEvent& event) { return std::holds_alternative<MonitorLostEvent>(event.event); }));
}

TEST_F(GlWindowTest, eventsHaveTheTimesWhenTheyCame) {
  test::XServer server;
  showQuarters();
  window_->pollTimed(0);
  int left = 0;
  int top = 0;
  glfwGetWindowPos(window_->handle(), &left, &top);
  const auto now = [] { return std::chrono::nanoseconds(Clock::now().time_since_epoch()).count(); };
  for (int i = 1; i <= 3; ++i) {
    const int64_t before = now();
    server.movePointer(left + 10 * i, top + 20);
    std::vector<TimedWindowEvent> moves;
    for (const auto start = Clock::now(); moves.empty() && secondsSince(start) < kPatience;) {
      for (const TimedWindowEvent& event : window_->pollTimed(0.05)) {
        const auto* const input = std::get_if<InputEvent>(&event.event);
        if (input != nullptr && std::holds_alternative<PointerMoveEvent>(*input)) {
          moves.push_back(event);
        }
      }
    }
    ASSERT_FALSE(moves.empty());
    EXPECT_GE(moves.back().nanoseconds, before);
    EXPECT_LE(moves.back().nanoseconds, now());
  }
}

TEST_F(GlWindowTest, anotherThreadDrawsWhileThisOneWaitsForEvents) {
  test::XServer server;
  window_->poll();
  std::atomic<bool> done{false};
  std::thread renderer([&] {
    const int width = window_->pixelWidth();
    const int height = window_->pixelHeight();
    const GlScope scope(window_->context());
    const GlObject color = makeTexture(window_->context(), GL_RGBA8, 1, 1);
    const std::array<uint8_t, 4> bytes{9, 80, 7, 255};
    window_->context().gl().TextureSubImage2D(color.id(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    const GlObject framebuffer = makeFramebuffer(window_->context(), std::array{color.id()}, 0);
    for (int i = 0; i < 30; ++i) {
      window_->present(framebuffer, 1, 1);
      window_->awaitFrame();
    }
    EXPECT_EQ(width, 300);
    EXPECT_EQ(height, 200);
    done = true;
    GlWindow::wake();
  });
  while (!done) {
    window_->pollTimed(kPatience);  // ended by wake()
  }
  renderer.join();
  int left = 0;
  int top = 0;
  glfwGetWindowPos(window_->handle(), &left, &top);
  EXPECT_EQ(server.screenPixel(left + 150, top + 100), (Rgb{9, 80, 7}));
}

// A virtual screen waits for nothing. Twenty frames of a sixtieth take a third of a second; a screen of 240 Hz, the
// fastest that tests may meet, 0.08 s.
TEST_F(GlWindowTest, doesNotOutrunTheScreen) {
  showQuarters();
  const auto start = Clock::now();
  for (int i = 0; i < 20; ++i) {
    showQuarters();
  }
  const GLFWvidmode mode = *glfwGetVideoMode(glfwGetPrimaryMonitor());
  const double rate = mode.refreshRate > 0 ? mode.refreshRate : 60;
  EXPECT_GE(secondsSince(start), 0.9 * 20 / rate);
}

TEST_F(GlWindowTest, waitsForEventsWhereThatIsWanted) {
  for (const auto start = Clock::now(); secondsSince(start) < 0.3;) {
    window_->poll(0.02);  // those of opening
  }
  const auto start = Clock::now();
  const auto events = window_->poll(0.1);
  EXPECT_TRUE(events.empty());
  EXPECT_GE(secondsSince(start), 0.09);
}

TEST_F(GlWindowTest, panelsTakeItsEvents) {
  test::XServer server;
  GuiLayer gui(window_->context(), window_->size().contentScale);
  const GlScope scope(window_->context());
  const int width = window_->pixelWidth();
  const int height = window_->pixelHeight();
  const GlObject color = makeTexture(window_->context(), GL_RGBA8, width, height);
  const GlObject framebuffer = makeFramebuffer(window_->context(), std::array{color.id()}, 0);
  int left = 0;
  int top = 0;
  glfwGetWindowPos(window_->handle(), &left, &top);
  bool pressed = false;
  const auto start = Clock::now();
  for (int i = 0; !pressed && secondsSince(start) < kPatience; ++i) {
    if (i % 10 == 5) {
      server.movePointer(left + 30, top + 30);
      server.pressButton(1, true);
      server.pressButton(1, false);
    }
    for (const InputEvent& event : window_->poll()) {
      gui.handle(event);
    }
    window_->context().gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gui.beginFrame(1.0 / 60);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
    pressed = ImGui::Button("press here", {100, 40});
    ImGui::End();
    gui.endFrame();
    window_->show(framebuffer, width, height);
  }
  EXPECT_TRUE(pressed);
}

GLenum GLAD_API_PTR reportReset() {
  return GL_UNKNOWN_CONTEXT_RESET;
}

TEST_F(GlWindowTest, tellsOfALostContextWhereAFrameIsShown) {
  showQuarters();
  const GlScope scope(window_->context());
  const GlObject color = makeTexture(window_->context(), GL_RGBA8, 4, 4);
  const GlObject framebuffer = makeFramebuffer(window_->context(), std::array{color.id()}, 0);
  window_->context().functions().GetGraphicsResetStatus = reportReset;
  try {
    window_->show(framebuffer, 4, 4);
    FAIL() << "nothing was thrown";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("window"), testing::HasSubstr("context is lost"),
                                             testing::HasSubstr("showing a frame")));
  }
}

// Drivers read their environment once, so it is a process of its own.
TEST(GlWindowDeathTest, refusesADriverBelow45) {
  if (std::getenv("DISPLAY") == nullptr) {
    GTEST_SKIP() << kNoDisplay;
  }
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto open = [] {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    try {
      GlWindow window({.visible = false});
    } catch (const GlError& error) {
      std::fputs(error.what(), stderr);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(open(), testing::ExitedWithCode(0),
              testing::AllOf(testing::HasSubstr("OpenGL 4.5"), testing::HasSubstr("window"),
                             testing::HasSubstr("--offscreen"), testing::HasSubstr("on the CPU")));
}

TEST_F(GlWindowTest, opensAndClosesAHundredTimes) {
  window_.reset();
  for (int i = 0; i < 100; ++i) {
    GlWindow window({.title = "again", .width = 64, .height = 48, .visible = i % 2 == 0});
    const GlScope scope(window.context());
    const GlObject buffer = makeBuffer(window.context(), 1 << 20);
    EXPECT_EQ(window.context().liveObjects(), 1);
    window.poll();
  }
}

TEST_F(GlWindowTest, livesBesideOtherWindowsAndContexts) {
  GlWindow other({.title = "other", .width = 100, .height = 100, .visible = true, .debug = GlDebug::kErrorsAreFatal});
  const auto osMesa = openTestContext(GlProvider::kOsMesa);
  const auto egl = openTestContext(GlProvider::kEgl);
  for (GlContext* context : {&window_->context(), osMesa.get(), &other.context(), egl.get(), &window_->context()}) {
    const GlScope scope(*context);
    const GlObject buffer = makeBuffer(*context, std::vector<int>{1, 2, 3});
    std::array<int, 3> back{};
    readBuffer(*context, buffer, sizeof(back), back.data());
    EXPECT_THAT(back, testing::ElementsAre(1, 2, 3));
  }
  showQuarters();
}

}  // namespace
}  // namespace ocelli
