// The `ocelli` program, and what it shares with others that have commands.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

/// Returns the exit code: 0 done, 1 the work failed, 2 the command line or an input file is wrong.
int runProgram(int argumentCount, char** arguments);

using AddCommands = std::function<void(CLI::App& program, const CommandContext& context)>;

/// The same for a program with these commands alone: command_line.cpp.
int runCommandLine(int argumentCount, char** arguments, const AddCommands& addCommands);

}  // namespace ocelli
