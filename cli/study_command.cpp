// `ocelli study`: perception studies, from the protocol to the data.
#include "cli/study_command.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace ocelli {

void addStudyCommand(CLI::App& program, const Frame& frame) {
  CLI::App& study = *program.add_subcommand("study", "Run perception studies and keep their data");
  study.require_subcommand(1);
  addStudyCheckCommand(study, frame);
  addStudyRunCommands(study, frame);
  addStudySimulateCommand(study, frame);
  addStudyReplayCommand(study, frame);
  addStudyDataCommands(study, frame);
}

}  // namespace ocelli
