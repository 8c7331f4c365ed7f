#include "oc_core/window/gui_window.h"

#include <cmath>
#include <utility>

namespace ocelli {

glm::ivec2 GuiWindow::pixels() const {
  return {static_cast<int>(std::lround(window_.width * window_.pixelsPerUnit)),
          static_cast<int>(std::lround(window_.height * window_.pixelsPerUnit))};
}

void GuiWindow::handle(const InputEvent& event) {
  isChanged_ = true;
  gui_.handle(event);
  if (const auto* resized = std::get_if<ResizeEvent>(&event)) {
    window_ = *resized;
  } else if (std::holds_alternative<CloseEvent>(event)) {
    state().wantsClose = true;
  }
  take(event);
  if (std::exchange(state().wantsClose, false)) {
    wantsClose_ = mayClose();
  }
}

void GuiWindow::update(double seconds) {
  sinceDrawn_ += seconds;
  advance(seconds);
}

bool GuiWindow::needsDrawing() const {
  return pixels().x > 0 && pixels().y > 0 && (isChanged_ || gui_.hasWaitingEvents());
}

void GuiWindow::draw() {
  const glm::ivec2 size = pixels();
  if (size.x <= 0 || size.y <= 0) {
    return;
  }
  isChanged_ = false;
  const GlScope scope(context_);
  target_.resize(size.x, size.y);
  target_.clear(kGuiBackground);
  paint();
  target_.bind();
  gui_.beginFrame(std::exchange(sinceDrawn_, 0));
  drawPanels();
  gui_.endFrame();
}

Image<Rgb8> GuiWindow::screenshot() const {
  const GlScope scope(context_);
  return target_.read();
}

bool GuiWindow::takeFullscreenWish() {
  return std::exchange(state().wantsFullscreen, false);
}

}  // namespace ocelli
