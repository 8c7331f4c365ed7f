// `ocelli feeds evaluate`: simulated feeds beside the graph camera's own rendering.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {

void addFeedsEvaluateCommand(CLI::App& feeds, const CommandContext& context,
                             const FeedsWorkOf<FeedsEvaluateChoice>& work) {
  CLI::App& command = *feeds.add_subcommand(
      "evaluate", "Compare the image of simulated feeds with the graph camera's own rendering of the scene");
  const auto choice = std::make_shared<FeedsEvaluateChoice>();
  command.add_option("FOLDER", choice->folder, "What `ocelli feeds simulate` wrote")->required()->type_name("FOLDER");
  command.add_option("--setup", choice->setup, "Another setup of the same feeds, as `faces` and `edit` write them")
      ->type_name("SETUP.json");
  command.add_option("--seconds", choice->options.seconds, "How much of it; all by default")
      ->check(numberCheck(1e-3, 1e9))
      ->type_name("S");
  command
      .add_option("--page", choice->page,
                  "A folder for a page about errors: kinds, times, pictures beside rendered ones")
      ->type_name("FOLDER");
  command
      .add_option("--stitcher", choice->options.stitchEvery,
                  "Put each so manieth frame into OpenCV's stitcher, too, to compare")
      ->check(CLI::Range(size_t{1}, size_t{1000000}))
      ->type_name("N");
  addHiddenOption(command, choice->options.showsHidden);
  addFiguresOption(command, choice->json);
  context.finish(command, "  ocelli feeds evaluate corridor --page errors --json figures.json",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
