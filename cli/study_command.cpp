// `ocelli study`: perception studies, from the protocol to the data.
#include "cli/study_command.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace ocelli {

void addStudyCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& study = *program.add_subcommand("study", "Run perception studies and keep their data");
  study.require_subcommand(1);
  addStudyCheckCommand(study, context);
  addStudyRunCommands(study, context);
  addStudySimulateCommand(study, context);
  addStudyReplayCommand(study, context);
  addStudyLatencyCommand(study, context);
  addStudyDataCommands(study, context);
}

}  // namespace ocelli
