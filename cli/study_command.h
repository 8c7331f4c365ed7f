// The commands of `ocelli study`, one function a file.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class Frame;

// Each adds one or more commands below `study`, as the recipe in cli/command.h says of the program's own.
void addStudyCheckCommand(CLI::App& study, const Frame& frame);
void addStudyRunCommands(CLI::App& study, const Frame& frame);  ///< run, resume
void addStudySimulateCommand(CLI::App& study, const Frame& frame);
void addStudyReplayCommand(CLI::App& study, const Frame& frame);
void addStudyDataCommands(CLI::App& study, const Frame& frame);  ///< subjects, withdraw, merge, export

}  // namespace ocelli
