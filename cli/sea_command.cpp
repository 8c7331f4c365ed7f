#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/sea_export_command.h"

namespace ocelli {

void addSeaCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& sea = *program.add_subcommand("sea", "Many views of a place");
  sea.require_subcommand(1);
  addSeaExportCommand(sea, context);
}

}  // namespace ocelli
