// `ocelli feeds panes`: the feeds side by side, as surveillance shows them, to compare.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {

void addFeedsPanesCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsPanesChoice>& work) {
  CLI::App& command = *feeds.add_subcommand("panes", "Show the same feeds side by side, to compare");
  const auto choice = std::make_shared<FeedsPanesChoice>();
  command.add_option("SETUP", choice->setup, "The feeds and their frusta")->required()->type_name("SETUP.json");
  addOutputOption(command, choice->output, "A video, or an image of the last frame", {".mp4", ".mkv", ".png"});
  command.add_option("--seconds", choice->seconds, "How long; until the last feed ends by default")
      ->check(numberCheck(1e-3, 1e9))
      ->type_name("S");
  context.finish(command, "  ocelli feeds panes corridor/setup.json -o panes.mp4",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
