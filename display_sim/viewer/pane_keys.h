// Keys that mean something else in one pane, before they do what they do elsewhere (viewer_keys.h).
#pragma once

#include <vector>

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/base/input_event.h"

namespace ocelli {

/// What became of a key.
struct PaneKeyOutcome {
  bool used = false;      ///< otherwise it means what it means elsewhere
  const char* note = "";  ///< what the user should know; empty: nothing
};
inline constexpr PaneKeyOutcome kKeyUsed{true, ""};
inline constexpr PaneKeyOutcome kKeyMeansElsewhere{false, ""};

struct PaneKey {
  Key key;
  PaneKeyOutcome (*apply)(ViewerState& state);
  const char* keys;  ///< as in KeyBinding
  const char* text;
  bool shift = false;
  bool control = false;
};

/// What the key of an event does among `keys`, where `pane` is the active one and no help is open.
PaneKeyOutcome applyPaneKey(const std::vector<PaneKey>& keys, Pane pane, ViewerState& state, const KeyEvent& event);

}  // namespace ocelli
