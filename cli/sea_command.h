// The commands of `ocelli sea`, a file each.
#pragma once

#include "cli/command.h"

namespace ocelli {

void addSeaBuildCommand(CLI::App& sea, const CommandContext& context);
void addSeaEvaluateCommand(CLI::App& sea, const CommandContext& context);
void addSeaExportCommand(CLI::App& sea, const CommandContext& context);
void addSeaGetCommand(CLI::App& sea, const CommandContext& context);
void addSeaInfoCommand(CLI::App& sea, const CommandContext& context);
void addSeaViewCommand(CLI::App& sea, const CommandContext& context);
void addSeaVerifyCommand(CLI::App& sea, const CommandContext& context);

}  // namespace ocelli
