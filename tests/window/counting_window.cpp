#include "tests/window/counting_window.h"

#include <imgui.h>

#include <array>
#include <stdexcept>

#include "oc_core/gl/gl_api.h"

namespace ocelli::test {

void CountingWindow::take(const InputEvent& event) {
  taken.push_back(event);
  if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && key->key == Key::kEscape) {
    state_.closeHelpOrWindow();
  }
}

void CountingWindow::advance(double seconds) {
  advanced += seconds;
  if (isMoving) {
    requestDrawing();
  }
}

void CountingWindow::paint() {
  if (failsToPaint) {
    throw std::domain_error("nothing to paint");
  }
  const GladGLContext& gl = context().gl();
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, pixels().x / 2, pixels().y);
  const auto [red, green, blue] = kGuiField.floats();
  const std::array<float, 4> color{red, green, blue, 1};
  gl.ClearNamedFramebufferfv(target().framebuffer().id(), GL_COLOR, 0, color.data());
}

void CountingWindow::drawPanels() {
  ++draws;
  frameSeconds = ImGui::GetIO().DeltaTime;
  const glm::vec2 window(size());
  ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {window.x, window.y / 2}, kGuiAccent.packed());
}

bool CountingWindow::mayClose() {
  ++askedToClose;
  return !staysOpen;
}

}  // namespace ocelli::test
