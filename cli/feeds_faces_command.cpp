// `ocelli feeds faces`: near faces from the openings of a place.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {

void addFeedsFacesCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsFacesChoice>& work) {
  CLI::App& command =
      *feeds.add_subcommand("faces", "Find the near faces of feeds: the openings of a place that they look through");
  const auto choice = std::make_shared<FeedsFacesChoice>();
  command.add_option("SETUP", choice->setup, "The feeds, and the frustum that is the root")
      ->required()
      ->type_name("SETUP.json");
  command.add_option("--place", choice->place, "The place as a scene, in the world of the setup")
      ->required()
      ->type_name("SCENE");
  command.add_option("--metre", choice->metre, "Units of the scene in a metre; by default as its size suggests")
      ->check(numberCheck(1e-6, 1e6))
      ->type_name("UNITS");
  command
      .add_option("--turn", choice->maxTurnDegrees,
                  "How far openings that are seen from the side are turned towards who looks at them, at most")
      ->check(numberCheck(0, 80))
      ->capture_default_str()
      ->type_name("DEGREES");
  addOutputOption(command, choice->output, "The setup with its frusta", {".json"});
  context.finish(command, "  ocelli feeds faces corridor/setup.json --place builtin:corridor_t -o corridor/faces.json",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
