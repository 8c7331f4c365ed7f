#include "display_sim/viewer/pane_keys.h"

#include <algorithm>

namespace ocelli {

PaneKeyOutcome applyPaneKey(const std::vector<PaneKey>& keys, Pane pane, ViewerState& state, const KeyEvent& event) {
  if (state.active != pane || !event.pressed || event.modifiers.alt || state.help) {
    return kKeyMeansElsewhere;
  }
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const PaneKey& each) {
    return each.key == event.key && each.shift == event.modifiers.shift && each.control == event.modifiers.control;
  });
  return found == keys.end() ? kKeyMeansElsewhere : found->apply(state);
}

}  // namespace ocelli
