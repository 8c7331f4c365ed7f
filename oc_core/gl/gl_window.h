// A window with an OpenGL context, made with GLFW. Windows are opened, used and closed on the main thread.
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

#include <memory>
#include <string>
#include <vector>

#include "oc_core/gl/gl_context.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/base/input_event.h"

struct GLFWwindow;

namespace ocelli {

struct GlWindowOptions {
  std::string title = "Ocelli";
  int width = 1280;  ///< at 96 dots an inch; larger on a denser screen
  int height = 800;
  bool visible = true;
  GlDebug debug = GlDebug::kOff;
};

class GlWindow {
 public:
  /// Throws GlError where there is no display, or no OpenGL 4.5 on it.
  explicit GlWindow(const GlWindowOptions& options);
  /// No GlObject of its context may be alive.
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  GlContext& context() { return *context_; }

  /// What has happened since the last call, in its order, but for a change of size, which comes first. Waits at most so
  /// long for something to happen. A CloseEvent is a wish: the window stays until it is destroyed.
  std::vector<InputEvent> poll(double waitSeconds = 0);

  /// The size now.
  ResizeEvent size() const;
  int pixelWidth() const;
  int pixelHeight() const;

  /// Shows a framebuffer of so many pixels, its row 0 at the top, stretched over the window where the size differs.
  /// Then waits for the screen. Hold a GlScope. Throws GlError.
  void show(const GlObject& framebuffer, int width, int height);

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
