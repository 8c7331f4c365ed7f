// `ocelli present` on a picture device: quilts of a scene, which plays where it moves.
#pragma once

#include "cli/command.h"
#include "cli/present_choice.h"

namespace ocelli {

/// Throws InputError where options were given that are of volumes, and as openPictureDevice() and loadScene() do.
void presentQuilt(const PresentChoice& choice, const CommandContext& context);

}  // namespace ocelli
