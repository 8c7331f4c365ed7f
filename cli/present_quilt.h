// `ocelli present` on a picture device: quilts of a scene, which plays where it moves.
#pragma once

#include "cli/command.h"
#include "cli/present_choice.h"

namespace CLI {
class App;
}

namespace ocelli {

/// `command` is the one that was given. Throws InputError where it has options that picture devices do not take, and as
/// openPictureDevice() and loadScene() do.
void presentQuilt(const PresentChoice& choice, const CLI::App& command, const CommandContext& context);

}  // namespace ocelli
