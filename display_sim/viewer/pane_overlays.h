// What stands over and in the panes as text: their titles with figures, legends of their colours, and the sample under
// the pointer.
#pragma once

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// Between the beginning and the end of a frame of the GuiLayer.
void drawPaneOverlays(const PanelDrawing& drawing);

/// "pixel 312, 200: z 9.8740, displaced 12.30 -0.40", then its colour on a second line; or "... no sample".
std::string sampleText(const ReferenceImage& image, const glm::ivec2& pixel);
/// "missing 1.23 %, thick 0.10 %".
std::string missingText(const MissingSamples& missing);

}  // namespace ocelli
