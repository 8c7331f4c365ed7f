// What keys do in the pane of the transfer function, before they do what they do elsewhere.
#pragma once

#include <vector>

#include "display_sim/viewer/pane_keys.h"

namespace ocelli {

const std::vector<PaneKey>& transferKeys();

/// Where that pane is active. A key that is let go ends a step that undo() takes back, wherever it is: a key that is
/// held repeats, and is one step.
PaneKeyOutcome applyTransferKey(ViewerState& state, const KeyEvent& event);

}  // namespace ocelli
