// What stands over and in the effect pane: what the picture is and how far it is from the traced one, in words, and
// buttons that switch between them.
#pragma once

#include <string>
#include <vector>

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// Beside the title: the effect, its way, and the size of the picture.
std::string effectDetail(const ViewerState& state, const EffectStatus& status);
/// In the pane: what it shows, what is being made, or why there is nothing; from the longest form to the shortest, one
/// at least. Times are left out where they may not be shown.
std::vector<std::string> effectNotes(const ViewerState& state, const EffectStatus& status, bool showTimes);

/// At the lower right of the pane's image, between the beginning and the end of a frame of the GuiLayer; nothing where
/// the pane is too small for them. Returns the height that they take.
float drawEffectSwitch(const PanelDrawing& drawing, const WindowRect& image);

}  // namespace ocelli
