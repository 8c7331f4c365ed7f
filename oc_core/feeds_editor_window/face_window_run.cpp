// runFaceWindow(): the window on a screen.
#include <chrono>

#include "oc_core/feeds_editor_window/face_window.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

constexpr double kEditorRest = 0.1;  ///< seconds that it waits for something to happen

}  // namespace

void runFaceWindow(FaceEditor& editor, const FaceWindowOptions& options, const std::function<bool()>& goesOn) {
  GlWindow window({.title = options.title, .width = 1280, .height = 800});
  FaceWindow shown(window.context(), editor, options);
  auto last = std::chrono::steady_clock::now();
  while (!shown.wantsClose() && (!goesOn || goesOn())) {
    for (const InputEvent& event : window.poll(kEditorRest)) {
      shown.handle(event);
    }
    if (shown.takeFullscreenWish()) {
      window.setFullscreen(!window.isFullscreen());
    }
    if (shown.needsDrawing()) {
      const auto now = std::chrono::steady_clock::now();
      shown.draw(std::chrono::duration<double>(now - last).count());
      last = now;
      const GlScope scope(window.context());
      window.show(shown.framebuffer(), shown.pixelWidth(), shown.pixelHeight());
    }
  }
}

}  // namespace ocelli
