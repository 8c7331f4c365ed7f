// The section of the panel on the left for a volume: its transfer function in numbers, light, clipping and its surface.
#pragma once

#include <string>

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

class VolumeForm {
 public:
  void draw(const PanelDrawing& drawing, float valueWidth);
  /// The next frame gives the keyboard to the numbers of the chosen point.
  void focusPoint() { wantsPoint_ = true; }

 private:
  void drawPoint(TransferEditor& editor);
  void drawFile(const PanelDrawing& drawing, float valueWidth);
  void drawIso(const PanelDrawing& drawing);

  bool wantsPoint_ = false;
  bool wasActive_ = false;  ///< something in the panels
  std::string file_;
  double iso_ = 0;                       ///< as it is being typed
  std::optional<uint64_t> isoRevision_;  ///< of the volume that iso_ was set for
};

}  // namespace ocelli
