// The commands of `ocelli remote`, one function a file.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

// Each adds a command below `remote`, as the recipe in cli/command.h says of the program's own.
void addRemoteMeasure(CLI::App& remote, const CommandContext& context);

}  // namespace ocelli
