// Over the picture of the lens pane: its lenses as thin outlines with handles, and what it says in words.
#pragma once

#include "display_sim/viewer/lens_pointer.h"
#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// Where the picture lies in the window.
LensPointer::Frame lensFrame(const ViewerState& state, const WindowRect& image, float lengthScale);

/// Outlines: each is light on a dark casing, so that it shows on every ground; the region in a line, the outer edge of
/// its transition dashed. The chosen one is yellow and thicker; locked ones have no handles, and say so.
void drawLensOutlines(const PanelDrawing& drawing, const WindowRect& image);

/// For the header: "cubic, 2 lenses, 720 x 480".
std::string lensDetail(const ViewerState& state, const LensStatus& status);
/// What the pane says, from the longest to the shortest form.
std::vector<std::string> lensNotes(const ViewerState& state, const LensStatus& status, bool showTimes);

}  // namespace ocelli
