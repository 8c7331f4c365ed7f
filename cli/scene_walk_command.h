// `ocelli scene walk`.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addSceneWalk(CLI::App& parent, const CommandContext& context);

}  // namespace ocelli
