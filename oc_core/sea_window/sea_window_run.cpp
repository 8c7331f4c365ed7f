// runSeaWindow(): the window on a screen.
#include <chrono>

#include "oc_core/sea_window/sea_window.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

constexpr double kSeaWait = 1.0 / 60;  ///< while something moves
constexpr double kSeaRest = 0.1;

}  // namespace

void runSeaWindow(const SeaFile& sea, const std::string& title, const std::function<bool()>& goesOn) {
  GlWindow window({.title = title, .width = 1280, .height = 800});
  SeaWindow shown(window.context(), sea, [] { GlWindow::wake(); });
  auto last = std::chrono::steady_clock::now();
  bool isLively = true;
  while (!shown.wantsClose() && (!goesOn || goesOn())) {
    for (const TimedWindowEvent& timed : window.pollTimed(isLively ? kSeaWait : kSeaRest)) {
      if (const auto* input = std::get_if<InputEvent>(&timed.event)) {
        shown.handle(*input);
      } else if (const auto* focus = std::get_if<FocusEvent>(&timed.event); focus != nullptr && !focus->focused) {
        shown.loseFocus();
      }
    }
    const auto now = std::chrono::steady_clock::now();
    shown.update(std::chrono::duration<double>(now - last).count());
    last = now;
    if (shown.takeFullscreenWish()) {
      window.setFullscreen(!window.isFullscreen());
    }
    isLively = shown.needsDrawing();
    if (isLively) {
      shown.draw();
      const GlScope scope(window.context());
      window.show(shown.framebuffer(), shown.pixelWidth(), shown.pixelHeight());
    }
  }
}

}  // namespace ocelli
