#include "cli/effect_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "oc_core/shade/effects.h"

namespace ocelli {

std::string effectHelp() {
  std::string text;
  for (const Effect& effect : shadeEffects()) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", effect.name, effect.description);
  }
  return text;
}

void addRolesOption(CLI::App& command, std::string& file) {
  command
      .add_option("--roles", file,
                  "Which objects mirror, refract or cast; by default SCENE.roles.json beside the scene, and for "
                  "built-in scenes their own")
      ->type_name("FILE.json");
}

}  // namespace ocelli
