// `ocelli feeds edit`: near faces drawn in a window.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {

void addFeedsEditCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsEditChoice>& work) {
  CLI::App& command = *feeds.add_subcommand(
      "edit", "Draw the near faces of feeds in a window: a plan beside the image that they give; its keys: H");
  const auto choice = std::make_shared<FeedsEditChoice>();
  command.add_option("SETUP", choice->setup, "The feeds, and the frusta that there are")
      ->required()
      ->type_name("SETUP.json");
  command
      .add_option("--place", choice->place, "The place as a scene, in the world of the setup: its walls in the plan")
      ->type_name("SCENE");
  command.add_option("--metre", choice->metre, "Units of the scene in a metre; by default as its size suggests")
      ->check(numberCheck(1e-6, 1e6))
      ->type_name("UNITS");
  addOutputOption(command, choice->output, "The setup, as it is saved with Ctrl+S", {".json"});
  context.finish(command, "  ocelli feeds edit corridor/setup.json --place builtin:corridor_t -o corridor/setup.json",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
