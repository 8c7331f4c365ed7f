// The commands of `ocelli remote`, one function a file, and what they share.
#pragma once

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;
struct RemoteSettings;

// Each adds a command below `remote`, as the recipe in cli/command.h says of the program's own.
void addRemoteServe(CLI::App& remote, const CommandContext& context);
void addRemoteMeasure(CLI::App& remote, const CommandContext& context);

/// Adds an option for each row of remoteOptions(). `settings` must outlive the parsing.
void addRemoteSettingsOptions(CLI::App& command, RemoteSettings& settings);

}  // namespace ocelli
