// The commands of `ocelli study`, one function a file.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

// Each adds one or more commands below `study`, as the recipe in cli/command.h says of the program's own.
void addStudyCheckCommand(CLI::App& study, const CommandContext& context);
void addStudyRunCommands(CLI::App& study, const CommandContext& context);  ///< run, resume
void addStudySimulateCommand(CLI::App& study, const CommandContext& context);
void addStudyReplayCommand(CLI::App& study, const CommandContext& context);
void addStudyLatencyCommand(CLI::App& study, const CommandContext& context);
void addStudyDataCommands(CLI::App& study, const CommandContext& context);  ///< subjects, withdraw, merge, export

}  // namespace ocelli
