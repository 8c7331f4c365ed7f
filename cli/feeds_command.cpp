// `ocelli feeds`: graph cameras from video.
#include "cli/feeds_command.h"

#include <CLI/CLI.hpp>

namespace ocelli {

void addFeedsCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& feeds =
      *program.add_subcommand("feeds", "Graph cameras from video: one continuous image of several cameras' feeds");
  feeds.require_subcommand(1);
  addFeedsCalibrateCommand(feeds, context);
  addFeedsRunCommand(feeds, context);
  addFeedsSimulateCommand(feeds, context);
  addFeedsEvaluateCommand(feeds, context);
}

}  // namespace ocelli
