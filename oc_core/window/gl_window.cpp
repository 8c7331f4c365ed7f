#include "oc_core/window/gl_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <span>
#include <thread>
#include <type_traits>
#include <utility>

#include "oc_core/gl/gl_api.h"
#include "oc_core/window/frame_pacer.h"
#include "oc_core/window/glfw_input.h"
#include "oc_core/window/monitors.h"

namespace ocelli {
namespace {

class GlfwPlatform final : public GlPlatform {
 public:
  explicit GlfwPlatform(GLFWwindow* window) : window_(window) {}

  bool makeCurrent() override {
    glfwMakeContextCurrent(window_);
    return glfwGetCurrentContext() == window_;
  }
  void release() override { glfwMakeContextCurrent(nullptr); }
  Function function(const char* name) const override { return glfwGetProcAddress(name); }

 private:
  GLFWwindow* window_;
};

/// Nothing where the window shall not fill one.
GLFWmonitor* chosenMonitor(const GlWindowOptions& options) {
  if (!options.monitor) {
    return nullptr;
  }
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  if (*options.monitor < 0 || *options.monitor >= count || glfwGetVideoMode(monitors[*options.monitor]) == nullptr) {
    throw InputError("there is no such monitor", "monitor " + std::to_string(*options.monitor),
                     "choose one of the " + std::to_string(count) + " that are attached, counted from 0");
  }
  return monitors[*options.monitor];
}

GLFWwindow* createWindow(const GlWindowOptions& options) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, kGlMajorVersion);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, kGlMinorVersion);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug == GlDebug::kErrorsAreFatal ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // frames are drawn elsewhere
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, options.scaled ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_RESIZABLE, options.resizable ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, options.monitor ? GLFW_FALSE : GLFW_TRUE);
  GLFWmonitor* const monitor = chosenMonitor(options);
  int width = options.width;
  int height = options.height;
  if (monitor != nullptr) {
    const GLFWvidmode mode = *glfwGetVideoMode(monitor);
    width = mode.width;
    height = mode.height;
    glfwWindowHint(GLFW_REFRESH_RATE, mode.refreshRate);
  }
  // A lost context shall say so. Drivers that cannot notice it may refuse.
  for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
    if (GLFWwindow* window = glfwCreateWindow(width, height, options.title.c_str(), monitor, nullptr)) {
      return window;
    }
  }
  throw GlError("no window with OpenGL 4.5 can be opened" + lastGlfwError(), "window",
                "update the graphics driver, or use --offscreen");
}

/// The screen that shows most of a window; none where no screen is attached.
GLFWmonitor* monitorOf(GLFWwindow* window) {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  glfwGetWindowPos(window, &left, &top);
  glfwGetWindowSize(window, &width, &height);
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  int maxArea = 0;
  for (int i = 0; i < count; ++i) {
    int x = 0;
    int y = 0;
    glfwGetMonitorPos(monitors[i], &x, &y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) {
      continue;
    }
    const int across = std::min(left + width, x + mode->width) - std::max(left, x);
    const int down = std::min(top + height, y + mode->height) - std::max(top, y);
    const int area = std::max(across, 0) * std::max(down, 0);
    if (area > maxArea) {
      maxArea = area;
      best = monitors[i];
    }
  }
  return best;
}

double refreshRateOf(GLFWwindow* window) {
  GLFWmonitor* monitor = monitorOf(window);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  return mode != nullptr ? mode->refreshRate : 0;
}

}  // namespace

struct GlWindow::State {
  explicit State(const GlWindowOptions& options) : window(createWindow(options)), pacer(refreshRateOf(window)) {
    glfwSetWindowUserPointer(window, this);
    noteFramebuffer();
    glfwSetWindowSizeCallback(window, [](GLFWwindow* of, int, int) { get(of).resized = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* of, int, int) {
      get(of).resized = true;
      get(of).noteFramebuffer();
    });
    glfwSetWindowFocusCallback(window,
                               [](GLFWwindow* of, int focused) { get(of).add(FocusEvent{focused == GLFW_TRUE}); });
    if (GLFWmonitor* monitor = glfwGetWindowMonitor(window)) {
      monitorName = glfwGetMonitorName(monitor);
      glfwSetMonitorUserPointer(monitor, this);
      glfwSetMonitorCallback([](GLFWmonitor* of, int what) {
        auto* const state = static_cast<State*>(glfwGetMonitorUserPointer(of));
        if (what == GLFW_DISCONNECTED && state != nullptr) {
          state->add(MonitorLostEvent{state->monitorName});
        }
      });
    }
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* of, float, float) { get(of).resized = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* of) {
      glfwSetWindowShouldClose(of, GLFW_FALSE);
      get(of).add(CloseEvent{});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int /*scancode*/, int action, int modifiers) {
      if (const auto ours = keyFromGlfw(key)) {
        get(of).add(KeyEvent{*ours, action != GLFW_RELEASE, modifiersFromGlfw(modifiers)});
      }
    });
    glfwSetCharCallback(window, [](GLFWwindow* of, unsigned character) { get(of).add(TextEvent{character}); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) { get(of).add(PointerMoveEvent{x, y}); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int modifiers) {
      if (const auto ours = pointerButtonFromGlfw(button)) {
        get(of).add(PointerButtonEvent{*ours, action == GLFW_PRESS, modifiersFromGlfw(modifiers)});
      }
    });
    // GLFW's horizontal offset grows to the left.
    glfwSetScrollCallback(window, [](GLFWwindow* of, double x, double y) { get(of).add(ScrollEvent{-x, y}); });
    glfwSetDropCallback(window, [](GLFWwindow* of, int count, const char** paths) {
      get(of).add(DropEvent{std::vector<std::string>(paths, paths + count)});
    });
  }
  ~State() {
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    for (GLFWmonitor* monitor : std::span(monitors, static_cast<size_t>(count))) {
      if (glfwGetMonitorUserPointer(monitor) == this) {
        glfwSetMonitorUserPointer(monitor, nullptr);
      }
    }
    glfwDestroyWindow(window);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  static State& get(GLFWwindow* of) { return *static_cast<State*>(glfwGetWindowUserPointer(of)); }

  template <class Event>
  void add(Event event) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    using Variant = decltype(TimedWindowEvent::event);
    if constexpr (std::is_constructible_v<InputEvent, Event>) {
      events.push_back({Variant(InputEvent(std::move(event))), std::chrono::nanoseconds(now).count()});
    } else {
      events.push_back({Variant(std::move(event)), std::chrono::nanoseconds(now).count()});
    }
  }
  void noteFramebuffer() {
    int across = 0;
    int down = 0;
    glfwGetFramebufferSize(window, &across, &down);
    framebufferWidth = across;
    framebufferHeight = down;
  }

  GLFWwindow* window;
  FramePacer pacer;
  std::vector<TimedWindowEvent> events;
  std::string monitorName;
  // For the thread that draws.
  std::atomic<int> framebufferWidth{0};
  std::atomic<int> framebufferHeight{0};
  bool resized = true;  ///< the first poll() tells the size
  // Where the window was before it filled the screen.
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

GlWindow::GlWindow(const GlWindowOptions& options) {
  initializeGlfw();
  state_ = std::make_unique<State>(options);
  context_ =
      std::make_unique<GlContext>(GlProvider::kWindow, std::make_unique<GlfwPlatform>(state_->window), options.debug);
  const GlScope scope(*context_);
  glfwSwapInterval(1);
}

GlWindow::~GlWindow() = default;

std::vector<InputEvent> GlWindow::poll(double waitSeconds) {
  std::vector<InputEvent> events;
  for (TimedWindowEvent& timed : pollTimed(waitSeconds)) {
    if (auto* const input = std::get_if<InputEvent>(&timed.event)) {
      events.push_back(std::move(*input));
    }
  }
  return events;
}

std::vector<TimedWindowEvent> GlWindow::pollTimed(double waitSeconds) {
  if (waitSeconds > 0 && !state_->resized) {
    glfwWaitEventsTimeout(waitSeconds);
  } else {
    glfwPollEvents();
  }
  if (std::exchange(state_->resized, false)) {
    state_->add(size());
    std::rotate(state_->events.begin(), state_->events.end() - 1, state_->events.end());
  }
  return std::exchange(state_->events, {});
}

void GlWindow::wake() {
  glfwPostEmptyEvent();
}

ResizeEvent GlWindow::size() const {
  ResizeEvent size;
  glfwGetWindowSize(state_->window, &size.width, &size.height);
  float horizontal = 1;
  float vertical = 1;
  glfwGetWindowContentScale(state_->window, &horizontal, &vertical);
  size.contentScale = std::max(horizontal, 0.1F);
  size.pixelsPerUnit = size.width > 0 && pixelWidth() > 0 ? static_cast<double>(pixelWidth()) / size.width : 1;
  return size;
}

int GlWindow::pixelWidth() const {
  int width = 0;
  glfwGetFramebufferSize(state_->window, &width, nullptr);
  return width;
}

int GlWindow::pixelHeight() const {
  int height = 0;
  glfwGetFramebufferSize(state_->window, nullptr, &height);
  return height;
}

void GlWindow::present(const GlObject& framebuffer, int width, int height) {
  const GladGLContext& gl = context_->gl();
  const int toWidth = state_->framebufferWidth;
  const int toHeight = state_->framebufferHeight;
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.BlitNamedFramebuffer(framebuffer.id(), 0, 0, 0, width, height, 0, toHeight, toWidth, 0, GL_COLOR_BUFFER_BIT,
                          width == toWidth && height == toHeight ? GL_NEAREST : GL_LINEAR);
  glfwSwapBuffers(state_->window);
  context_->check("showing a frame");
}

void GlWindow::show(const GlObject& framebuffer, int width, int height) {
  present(framebuffer, width, height);
  std::this_thread::sleep_for(std::chrono::duration<double>(state_->pacer.wait(glfwGetTime())));
}

void GlWindow::awaitFrame() {
  const GladGLContext& gl = context_->gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, 1, 1);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Finish();
  context_->check("waiting for the screen");
}

void GlWindow::setCursor(CursorMode mode) {
  const auto theirs = [&] {
    switch (mode) {
      case CursorMode::kShown:
        return GLFW_CURSOR_NORMAL;
      case CursorMode::kHidden:
        return GLFW_CURSOR_HIDDEN;
      case CursorMode::kCaptured:
        return GLFW_CURSOR_DISABLED;
    }
    return GLFW_CURSOR_NORMAL;
  };
  glfwSetInputMode(state_->window, GLFW_CURSOR, theirs());
}

bool GlWindow::isFullscreen() const {
  return glfwGetWindowMonitor(state_->window) != nullptr;
}

void GlWindow::setFullscreen(bool fullscreen) {
  if (fullscreen == isFullscreen()) {
    return;
  }
  State& state = *state_;
  if (!fullscreen) {
    glfwSetWindowMonitor(state.window, nullptr, state.left, state.top, state.width, state.height, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = monitorOf(state.window);
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) {
    throw GlError("no screen is attached", "window", "attach one, or use --offscreen");
  }
  glfwGetWindowPos(state.window, &state.left, &state.top);
  glfwGetWindowSize(state.window, &state.width, &state.height);
  glfwSetWindowMonitor(state.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

GLFWwindow* GlWindow::handle() const {
  return state_->window;
}

}  // namespace ocelli
