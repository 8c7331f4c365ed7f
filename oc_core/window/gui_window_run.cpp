#include "oc_core/window/gui_window_run.h"

#include <chrono>

namespace ocelli {
namespace {

constexpr double kGuiWait = 1.0 / 60;  ///< for events, seconds, while something changes
constexpr double kGuiRest = 0.1;

}  // namespace

void runGuiWindow(GlWindow& window, GuiWindow& shown, const std::function<bool()>& goesOn) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  bool isChanging = true;
  while (!shown.wantsClose() && (!goesOn || goesOn())) {
    for (const TimedWindowEvent& timed : window.pollTimed(isChanging ? kGuiWait : kGuiRest)) {
      if (const auto* input = std::get_if<InputEvent>(&timed.event)) {
        shown.handle(*input);
      } else if (const auto* focus = std::get_if<FocusEvent>(&timed.event); focus != nullptr && !focus->focused) {
        shown.loseFocus();
      }
    }
    const auto now = Clock::now();
    shown.update(std::chrono::duration<double>(now - last).count());
    last = now;
    if (shown.takeFullscreenWish()) {
      window.setFullscreen(!window.isFullscreen());
    }
    isChanging = shown.needsDrawing();
    if (isChanging) {
      shown.draw();
      const GlScope scope(window.context());
      window.show(shown.target().framebuffer(), shown.target().width(), shown.target().height());
    }
  }
}

}  // namespace ocelli
