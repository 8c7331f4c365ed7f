#include "cli/feeds_command.h"

#include <CLI/CLI.hpp>

namespace ocelli {

void addFeedsCommands(CLI::App& program, const CommandContext& context, const FeedsWork& work) {
  CLI::App& feeds =
      *program.add_subcommand("feeds", "Graph cameras from video: one continuous image of several cameras' feeds");
  feeds.require_subcommand(1);
  addFeedsCalibrateCommand(feeds, context, work);
  addFeedsEditCommand(feeds, context, work.edit);
  addFeedsFacesCommand(feeds, context, work.faces);
  addFeedsRunCommand(feeds, context, work.run);
  addFeedsSimulateCommand(feeds, context, work.simulate);
  addFeedsEvaluateCommand(feeds, context, work.evaluate);
  addFeedsPanesCommand(feeds, context, work.panes);
}

}  // namespace ocelli
