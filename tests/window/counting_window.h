// A GuiWindow that notes what is asked of it.
#pragma once

#include <vector>

#include "oc_core/window/gui_window.h"

namespace ocelli::test {

/// The left half is painted in kGuiField, and the upper half of all of it is a panel of kGuiAccent.
class CountingWindow final : public GuiWindow {
 public:
  using GuiWindow::GuiWindow;

  GuiWindowState& state() override { return state_; }
  void loseFocus() override { ++lostFocus; }

  bool isMoving = false;
  bool failsToPaint = false;
  bool staysOpen = false;
  std::vector<InputEvent> taken;
  double advanced = 0;      ///< seconds
  double frameSeconds = 0;  ///< as Dear ImGui has them
  int draws = 0;
  int lostFocus = 0;
  int askedToClose = 0;

 private:
  void take(const InputEvent& event) override;
  void advance(double seconds) override;
  void paint() override;
  void drawPanels() override;
  bool mayClose() override;

  GuiWindowState state_;
};

}  // namespace ocelli::test
