// Which effect the effect pane shows, and by which way. The lists are those of oc_core/shade/effects.h.
#pragma once

#include <string>
#include <vector>

#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

/// The names of all effects.
std::vector<std::string> effectNames();
/// Those of the ways that lists offer of an effect. It may take others, such as the file of a camera.
std::vector<std::string> effectWayNames(const std::string& effect);
/// The way that is chosen: that of the state; the camera where none is and the effect takes its name; else the first of
/// the list, or the traced one. Empty where no effect is named.
std::string chosenWay(const ViewerState& state);

/// Turns the pane on. A way that the effect does not take goes. Throws InputError that lists them for another name.
void chooseEffect(ViewerState& state, const std::string& name);
/// Empty: the camera's. Throws InputError for one that the effect does not take, and where no effect is named.
void chooseEffectWay(ViewerState& state, const std::string& way);
/// The one that is `step` places further on in the list.
void chooseNextEffect(ViewerState& state, int step);
void chooseNextEffectWay(ViewerState& state, int step);

/// Shows the pane alone, and gives it the keys; hides it.
void openEffectPane(ViewerState& state);
void closeEffectPane(ViewerState& state);

}  // namespace ocelli
