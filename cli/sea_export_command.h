// `ocelli sea export`: views with depth in files of other programs.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addSeaExportCommand(CLI::App& sea, const CommandContext& context);

}  // namespace ocelli
