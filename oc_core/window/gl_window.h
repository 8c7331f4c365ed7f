// A window with an OpenGL context, made with GLFW. Windows are opened, asked for events and closed on the main thread;
// another thread may draw and show frames, if no other one does.
//
// Frames are drawn into a framebuffer object, as everywhere, and shown from there:
//
//   GlWindow window({.title = "Ocelli"});
//   for (bool open = true; open;) {
//     for (const InputEvent& event : window.poll()) { ... }   // the first is a ResizeEvent
//     const GlScope scope(window.context());
//     ... draw ...
//     window.show(framebuffer, width, height);
//   }
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/gl/gl_context.h"
#include "oc_core/gl/gl_object.h"

struct GLFWwindow;

namespace ocelli {

/// The window has the keyboard now, or has lost it.
struct FocusEvent {
  bool focused = true;
};
/// The screen that the window filled is gone.
struct MonitorLostEvent {
  std::string name;
};

/// What happened to a window, and when the main thread took it: the earliest time that GLFW can give, which has none
/// of its own. Of std::chrono::steady_clock.
struct TimedWindowEvent {
  std::variant<InputEvent, FocusEvent, MonitorLostEvent> event;
  int64_t nanoseconds = 0;
};

enum class CursorMode {
  kShown,     ///< the pointer of the system, as ever
  kHidden,    ///< over the window
  kCaptured,  ///< hidden, and its events go on beyond the borders of the screen; then it comes back to where it was
};

struct GlWindowOptions {
  std::string title = "Ocelli";
  int width = 1280;  ///< at 96 dots an inch; larger on a denser screen
  int height = 800;
  bool visible = true;
  bool resizable = true;
  bool scaled = true;            ///< whether a denser screen makes it larger
  std::optional<int> monitor{};  ///< fills that one of listMonitors(), in its mode, whatever the size above
  GlDebug debug = GlDebug::kOff;
};

class GlWindow {
 public:
  /// Throws GlError where there is no display, or no OpenGL 4.5 on it; InputError where there is no such monitor.
  explicit GlWindow(const GlWindowOptions& options);
  /// No GlObject of its context may be alive.
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  GlContext& context() { return *context_; }

  /// What has happened since the last call, in its order, but for a change of size, which comes first. Waits at most so
  /// long for something to happen. A CloseEvent is a wish: the window stays until it is destroyed.
  std::vector<InputEvent> poll(double waitSeconds = 0);

  /// The same with times, and with changes of the focus and of the monitor.
  std::vector<TimedWindowEvent> pollTimed(double waitSeconds);
  /// Ends the wait of poll(), from any thread.
  static void wake();

  /// The size now.
  ResizeEvent size() const;
  int pixelWidth() const;
  int pixelHeight() const;

  /// Shows a framebuffer of so many pixels, its row 0 at the top, stretched over the window where the size differs.
  /// Then waits for the screen. Hold a GlScope. Throws GlError.
  void show(const GlObject& framebuffer, int width, int height);
  /// The same, but waits for the screen alone, if it makes one wait. From any thread.
  void present(const GlObject& framebuffer, int width, int height);
  /// Returns when the frame that was shown last has replaced the one before, as far as OpenGL can tell: a pixel is
  /// drawn into the next frame, which drivers allow only once there is room for it, and awaited. From any thread.
  void awaitFrame();

  void setCursor(CursorMode mode);

  /// Over the whole of the screen that shows most of the window, and back.
  void setFullscreen(bool fullscreen);
  bool isFullscreen() const;

  /// Of GLFW, for tests.
  GLFWwindow* handle() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::unique_ptr<GlContext> context_;
};

}  // namespace ocelli
