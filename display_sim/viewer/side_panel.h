// The panel on the left: the scene, the camera and its parameters, the display, and what each pane shows.
#pragma once

#include "display_sim/viewer/lens_form.h"
#include "display_sim/viewer/viewer_facts.h"
#include "display_sim/viewer/volume_form.h"

namespace ocelli {

class SidePanel {
 public:
  /// Between the beginning and the end of a frame of the GuiLayer.
  void draw(const PanelDrawing& drawing);
  /// The next frame gives the keyboard to the panel.
  void focus() { wantsFocus_ = true; }
  /// The same, to the numbers of the chosen point of the transfer function.
  void focusPoint() {
    focus();
    volumeForm_.focusPoint();
  }

 private:
  void drawScene(const PanelDrawing& drawing);
  void drawCamera(const PanelDrawing& drawing);
  void drawImageSize(const PanelDrawing& drawing);
  static void drawDisplay(const PanelDrawing& drawing);
  static void drawShown(const PanelDrawing& drawing);
  static void drawButtons(const PanelDrawing& drawing);

  bool wantsFocus_ = false;
  LensForm lensForm_;
  VolumeForm volumeForm_;
  std::string source_;       ///< as it is being typed
  std::string knownSource_;  ///< of the state when that was typed
  glm::ivec2 size_{0};       ///< as it is being typed
  glm::ivec2 knownSize_{0};
};

}  // namespace ocelli
