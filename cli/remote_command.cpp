// `ocelli remote`: a scene that is drawn on one computer and looked at on another.
#include "cli/remote_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <variant>

#include "cli/command.h"
#include "cli/number_check.h"
#include "oc_core/remote/remote_settings.h"

namespace ocelli {

void addRemoteSettingsOptions(CLI::App& command, RemoteSettings& settings) {
  for (const RemoteOption& option : remoteOptions()) {
    std::string name = std::string("--") + option.name;
    std::ranges::replace(name, '_', '-');
    const auto add = [&](auto member) {
      CLI::Option* const added = command.add_option(name, settings.*member, option.meaning);
      added->group("Images");
      if (option.words != nullptr) {
        added->check(CLI::IsMember(option.words()))->type_name("NAME");
      } else {
        added->check(numberCheck(option.min, option.max))->type_name(*option.unit != '\0' ? option.unit : "NUMBER");
      }
    };
    std::visit(add, option.place);
  }
}

void addRemoteCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& remote = *program.add_subcommand("remote", "Look at a scene that another computer draws");
  remote.require_subcommand(1);
  // One line a command.
  addRemoteServe(remote, context);
  addRemoteMeasure(remote, context);
}

}  // namespace ocelli
