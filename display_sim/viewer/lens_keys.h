// What keys do in the lens pane, before they do what they do elsewhere (viewer_keys.h): one list, which the viewer
// follows and its help shows.
#pragma once

#include <string>
#include <vector>

#include "display_sim/viewer/viewer_keys.h"
#include "display_sim/viewer/viewer_state.h"
#include "oc_core/base/input_event.h"

namespace ocelli {

/// What became of a key.
struct LensKeyOutcome {
  bool used = false;      ///< otherwise it means what it means elsewhere
  const char* note = "";  ///< what the user should know; empty: nothing
};

struct LensKey {
  Key key;
  LensKeyOutcome (*apply)(ViewerState& state);
  const char* keys;  ///< as in KeyBinding
  const char* text;
  bool shift = false;
  bool control = false;
};

const std::vector<LensKey>& lensKeys();

/// What the pointer does in it (lens_pointer.h), for the help.
const std::vector<PointerBinding>& lensPointerBindings();

/// Where the lens pane is active. Lenses stay valid; locked ones stay as they are.
LensKeyOutcome applyLensKey(ViewerState& state, const KeyEvent& event);

}  // namespace ocelli
