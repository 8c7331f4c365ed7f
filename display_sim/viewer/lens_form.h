// The numbers of all lenses in the panel on the left, and what is done with them.
#pragma once

#include <string>

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

class LensForm {
 public:
  /// Whatever is entered, the lenses stay valid, as by hand: each gets the nearest value that there is room for.
  void draw(const PanelDrawing& drawing, float valueWidth);

 private:
  std::string file_;
};

}  // namespace ocelli
