// The transfer function of the viewer's volume: where it begins, presets, and files.
#pragma once

#include <string>

#include "display_sim/viewer/loaded_volume.h"
#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

/// Another volume has come: its own transfer function is edited from here on, nothing of it is clipped by hand, and all
/// of its values show.
void takeVolume(ViewerState& state, const LoadedVolume& volume);

/// A preset by its name, or a file; it can be undone. Throws InputError as transferByName() does, and where the scene
/// is no volume.
void chooseTransfer(ViewerState& state, const LoadedVolume* volume, const std::string& nameOrFile);

/// The JSON file of what is edited, with absolute values: what `--transfer` takes. Throws InputError where the scene is
/// no volume.
std::string transferFileText(const ViewerState& state);

}  // namespace ocelli
