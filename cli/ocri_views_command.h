// `ocelli ocri views`.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addOcriViews(CLI::App& ocri, const CommandContext& context);

}  // namespace ocelli
