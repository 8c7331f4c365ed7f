#include "cli/remote_settings_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/number_check.h"

namespace ocelli {

void addRemoteSettingsOptions(CLI::App& command, RemoteSettings& settings) {
  for (const RemoteOption& option : remoteOptions()) {
    std::string name = std::string("--") + option.name;
    std::replace(name.begin(), name.end(), '_', '-');
    const std::string unit = *option.unit != '\0' ? std::string(", ") + option.unit : "";
    if (const auto* const word = std::get_if<std::string RemoteSettings::*>(&option.place)) {
      command.add_option(name, settings.**word, option.meaning + unit)
          ->check(CLI::IsMember(option.words()))
          ->type_name("NAME");
    } else if (const auto* const whole = std::get_if<int RemoteSettings::*>(&option.place)) {
      command.add_option(name, settings.**whole, option.meaning + unit)
          ->check(CLI::Range(static_cast<int>(option.min), static_cast<int>(option.max)))
          ->type_name("N");
    } else {
      command.add_option(name, settings.*std::get<double RemoteSettings::*>(option.place), option.meaning + unit)
          ->check(numberCheck(option.min, option.max))
          ->type_name("NUMBER");
    }
  }
}

}  // namespace ocelli
