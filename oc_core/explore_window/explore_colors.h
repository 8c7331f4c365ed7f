// Colours of frusta and bends, the same in the view and in the plan. Numbers stand beside them, so that nobody has to
// tell colours apart.
#pragma once

#include "oc_core/window/gui_style.h"

namespace ocelli {

/// 0 is what does not bend; the others go round.
constexpr GuiColor exploreSeriesColor(int color) {
  return color <= 0 ? kGuiText : kGuiSeries[static_cast<size_t>(color - 1) % kGuiSeries.size()];
}

/// Of states that want attention, besides their words.
inline constexpr GuiColor kExploreAttention = kOkabeItoOrange;
/// Of what is picked.
inline constexpr GuiColor kExplorePicked = kOkabeItoYellow;

}  // namespace ocelli
