#include "oc_core/feeds_window/feeds_keys.h"

namespace ocelli {

const std::vector<FeedsKeyAction>& feedsKeyActions() {
  static const std::vector<FeedsKeyAction> kActions{
      {{Key::kE},
       "E",
       "erased pixels, which are not live: in red, or as background",
       [](FeedsWindowState& s) { s.hasRedErased = !s.hasRedErased; }},
      {{Key::kL}, "L", "show or hide the labels of feeds", [](FeedsWindowState& s) { s.hasLabels = !s.hasLabels; }},
      {{Key::kO},
       "O",
       "show or hide the outlines of near faces",
       [](FeedsWindowState& s) { s.hasOutlines = !s.hasOutlines; }},
      {{Key::kSpace, Key::kP},
       "Space, P",
       "pause, or go on: recorded feeds alone",
       [](FeedsWindowState& s) { s.wantsPause = true; }},
      {{Key::kPeriod, Key::kRight},
       "Right, .",
       "one image further, while paused",
       [](FeedsWindowState& s) { s.wantsStep = true; }},
      {{Key::kS}, "S", "save the image as it is shown, as PNG", [](FeedsWindowState& s) { s.wantsSave = true; }},
      {{Key::kF11}, "F11", "fill the screen, or not", [](FeedsWindowState& s) { s.wantsFullscreen = true; }},
      {{Key::kH, Key::kF1}, "H, F1", "show or hide this help", [](FeedsWindowState& s) { s.hasHelp = !s.hasHelp; }},
      {{Key::kEscape}, "Escape", "close the help, then the window", [](FeedsWindowState& s) {
         s.closeHelpOrWindow();
       }}};
  return kActions;
}

}  // namespace ocelli
