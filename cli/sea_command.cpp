// `ocelli sea`: seas of images.
#include "cli/sea_command.h"

#include <CLI/CLI.hpp>

namespace ocelli {

void addSeaCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& sea =
      *program.add_subcommand("sea", "Thousands of images of a place in one file, from which any one is had at once");
  sea.require_subcommand(1);
  addSeaBuildCommand(sea, context);
  addSeaInfoCommand(sea, context);
  addSeaGetCommand(sea, context);
  addSeaViewCommand(sea, context);
  addSeaEvaluateCommand(sea, context);
  addSeaVerifyCommand(sea, context);
  addSeaExportCommand(sea, context);
}

}  // namespace ocelli
