// The bar below the panes, the help, and messages.
#pragma once

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// Between the beginning and the end of a frame of the GuiLayer, here and below.
void drawStatusBar(const PanelDrawing& drawing);
void drawHelp(const PanelDrawing& drawing);
void drawMessage(const PanelDrawing& drawing);

}  // namespace ocelli
