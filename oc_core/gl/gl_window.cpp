#include "oc_core/gl/gl_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

#include "oc_core/gl/frame_pacer.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/glfw_input.h"

namespace ocelli {
namespace {

std::string lastError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? std::string(" (") + description + ")" : "";
}

/// GLFW stays initialised until the program ends: it would unload the graphics driver, which does not survive that.
void initialiseGlfw() {
  if (glfwInit() == GLFW_TRUE) {
    return;
  }
  const char* display = std::getenv("DISPLAY");
  const bool named = display != nullptr && *display != '\0';
  throw GlError("no display can be opened" + lastError(), named ? "DISPLAY=" + std::string(display) : "DISPLAY",
                "set DISPLAY to a running X server, or use --offscreen");
}

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

GLFWwindow* createWindow(const GlWindowOptions& options) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, kGlMajorVersion);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, kGlMinorVersion);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug == GlDebug::kErrorsAreFatal ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // frames are drawn elsewhere
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  // A lost context shall say so. Drivers that cannot notice it may refuse.
  for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
    if (GLFWwindow* window = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr)) {
      return window;
    }
  }
  throw GlError("no window with OpenGL 4.5 can be opened" + lastError(), "window",
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
  int mostArea = 0;
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
    if (area > mostArea) {
      mostArea = area;
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
    glfwSetWindowSizeCallback(window, [](GLFWwindow* of, int, int) { get(of).resized = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* of, int, int) { get(of).resized = true; });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* of, float, float) { get(of).resized = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* of) {
      glfwSetWindowShouldClose(of, GLFW_FALSE);
      get(of).events.emplace_back(CloseEvent{});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int /*scancode*/, int action, int modifiers) {
      if (const auto ours = keyFromGlfw(key)) {
        get(of).events.emplace_back(KeyEvent{*ours, action != GLFW_RELEASE, modifiersFromGlfw(modifiers)});
      }
    });
    glfwSetCharCallback(window,
                        [](GLFWwindow* of, unsigned character) { get(of).events.emplace_back(TextEvent{character}); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) {
      get(of).events.emplace_back(PointerMoveEvent{x, y});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int modifiers) {
      if (const auto ours = pointerButtonFromGlfw(button)) {
        get(of).events.emplace_back(PointerButtonEvent{*ours, action == GLFW_PRESS, modifiersFromGlfw(modifiers)});
      }
    });
    // GLFW's horizontal offset grows to the left.
    glfwSetScrollCallback(window, [](GLFWwindow* of, double x, double y) {
      get(of).events.emplace_back(ScrollEvent{-x, y});
    });
    glfwSetDropCallback(window, [](GLFWwindow* of, int count, const char** paths) {
      get(of).events.emplace_back(DropEvent{std::vector<std::string>(paths, paths + count)});
    });
  }
  ~State() { glfwDestroyWindow(window); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  static State& get(GLFWwindow* of) { return *static_cast<State*>(glfwGetWindowUserPointer(of)); }

  GLFWwindow* window;
  FramePacer pacer;
  std::vector<InputEvent> events;
  bool resized = true;  ///< the first poll() tells the size
  // Where the window was before it filled the screen.
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

GlWindow::GlWindow(const GlWindowOptions& options) {
  initialiseGlfw();
  state_ = std::make_unique<State>(options);
  context_ =
      std::make_unique<GlContext>(GlProvider::kWindow, std::make_unique<GlfwPlatform>(state_->window), options.debug);
  const GlScope scope(*context_);
  glfwSwapInterval(1);
}

GlWindow::~GlWindow() = default;

std::vector<InputEvent> GlWindow::poll(double waitSeconds) {
  if (waitSeconds > 0 && !state_->resized) {
    glfwWaitEventsTimeout(waitSeconds);
  } else {
    glfwPollEvents();
  }
  std::vector<InputEvent> events = std::exchange(state_->events, {});
  if (std::exchange(state_->resized, false)) {
    events.insert(events.begin(), size());
  }
  return events;
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

void GlWindow::show(const GlObject& framebuffer, int width, int height) {
  const GladGLContext& gl = context_->gl();
  const int toWidth = pixelWidth();
  const int toHeight = pixelHeight();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.BlitNamedFramebuffer(framebuffer.id(), 0, 0, 0, width, height, 0, toHeight, toWidth, 0, GL_COLOR_BUFFER_BIT,
                          width == toWidth && height == toHeight ? GL_NEAREST : GL_LINEAR);
  glfwSwapBuffers(state_->window);
  context_->check("showing a frame");
  std::this_thread::sleep_for(std::chrono::duration<double>(state_->pacer.wait(glfwGetTime())));
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
