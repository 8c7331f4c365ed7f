// Which part of the sweep an eye still sees where the display is shown in slow motion, or stopped.
#pragma once

#include <vector>

#include "display_sim/observing/exposure.h"

namespace ocelli {

struct SweepWindow {
  double endRadians = 0;    ///< where the screen stands
  double sweptRadians = 0;  ///< how far it came while the window was open: at most kMaxSweptTurns
  /// How far the screen moves until what it showed has faded to 1 / e; 0: it does not fade while the window is open.
  double fadeRadians = 0;
};

inline constexpr double kMaxSweptTurns = 16;

/// By slice; `passes` is the share of the light that remains, added up over the turns. Angles as exposedArcs() gives
/// them. Throws InputError for windows that make no sense.
std::vector<ExposedArc> windowArcs(const DisplayProfile& profile, const SweepWindow& window, const Wobble& wobble = {});

}  // namespace ocelli
