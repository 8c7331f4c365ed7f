// What keys do in the lens pane, before they do what they do elsewhere (viewer_keys.h): one list, which the viewer
// follows and its help shows.
#pragma once

#include <vector>

#include "display_sim/viewer/pane_keys.h"
#include "display_sim/viewer/viewer_keys.h"

namespace ocelli {

const std::vector<PaneKey>& lensKeys();

/// What the pointer does in it (lens_pointer.h), for the help.
const std::vector<PointerBinding>& lensPointerBindings();

/// Where the lens pane is active. Lenses stay valid; locked ones stay as they are.
PaneKeyOutcome applyLensKey(ViewerState& state, const KeyEvent& event);

}  // namespace ocelli
