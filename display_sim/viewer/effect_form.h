// The part of the side panel that chooses an effect and its way.
#pragma once

#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// Within a window of Dear ImGui. `valueWidth` is that of its lists. Throws InputError as effect_choice.h does.
void drawEffectForm(const PanelDrawing& drawing, float valueWidth);

}  // namespace ocelli
