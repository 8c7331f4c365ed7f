// `ocelli remote`: scenes explored over a network.
#include "cli/remote_command.h"

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace ocelli {

void addRemoteCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& remote = *program.add_subcommand("remote", "Explore a scene over a network, and measure that");
  remote.require_subcommand(1);
  addRemoteMeasure(remote, context);
}

}  // namespace ocelli
