// `ocelli feeds calibrate`: sheets to print, lenses, poses, and whether cameras have moved.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {
namespace {

CLI::Option* addPlacesOptions(CLI::App& command, std::string& setup, std::string& places, const std::string& help) {
  command.add_option("SETUP", setup, "The feeds")->required()->type_name("SETUP.json");
  return command.add_option("--places", places, help)->type_name("PLACES.json");
}

CLI::Option& addBoardOption(CLI::App& command, std::string& board, const std::string& help) {
  return *command.add_option("--board", board, "COLUMNSxROWS:SQUARE:MARKER:DICTIONARY in mm, " + help)
              ->type_name("BOARD");
}

void addSheet(CLI::App& calibrate, const CommandContext& context, const FeedsWorkOf<FeedsSheetChoice>& work) {
  CLI::App& command = *calibrate.add_subcommand("sheet", "Print a board, tags, or both as PDF");
  const auto choice = std::make_shared<FeedsSheetChoice>();
  addOutputOption(command, choice->output, "The sheet", {".pdf"});
  addBoardOption(command, choice->board, std::string("without --tags ") + kUsualBoard);
  CLI::Option* const tags = command.add_option("--tags", choice->tags, "AprilTags 36h11 of these numbers");
  tags->check(CLI::Range(0, static_cast<int>(kMaxKnownTags) - 1))->delimiter(',')->type_name("N,N,...");
  command.add_option("--tag-size", choice->tagMillimetres, "Side of the black square")
      ->needs(tags)
      ->check(numberCheck(5, 2000))
      ->capture_default_str()
      ->type_name("MM");
  command.add_option("--paper", choice->paper, "a4 to a0, lying, or WIDTHxHEIGHT in mm")->capture_default_str();
  context.finish(command,
                 "  ocelli feeds calibrate sheet -o board.pdf\n"
                 "  ocelli feeds calibrate sheet --tags 0,1,2,3 --tag-size 150 --paper a3 -o tags.pdf",
                 [choice, context, work] { work(*choice, context); });
}

/// `calibrate --sheet FILE`, in place of a subcommand: what is usual, without another word.
void addUsualSheet(CLI::App& calibrate, const CommandContext& context, const FeedsWorkOf<FeedsSheetChoice>& work) {
  const auto choice = std::make_shared<FeedsSheetChoice>();
  choice->board = kUsualBoard;
  choice->tags = {0, 1, 2, 3};
  CLI::App& group = *calibrate.add_option_group("Without a subcommand");
  addSecondOutputOption(group, "--sheet", choice->output, "Print the usual board and tags 0 to 3, for A4", {".pdf"});
  context.finish(group, "", [choice, context, work] { work(*choice, context); });
  calibrate.require_subcommand(0, 1);
  calibrate.callback([&calibrate, &group] {
    const std::vector<CLI::App*> chosen = calibrate.get_subcommands();
    const bool hasSheet = group.count("--sheet") > 0;
    if (chosen.empty() && !hasSheet) {
      throw CLI::RequiredError::Subcommand(1);
    }
    if (!chosen.empty() && hasSheet) {
      throw CLI::ExcludesError("--sheet", chosen.front()->get_name());
    }
  });
}

void addLens(CLI::App& calibrate, const CommandContext& context, const FeedsWorkOf<FeedsLensChoice>& work) {
  CLI::App& command = *calibrate.add_subcommand("lens", "Find a lens from views of a board");
  const auto choice = std::make_shared<FeedsLensChoice>();
  command.add_option("VIEWS", choice->views, "A video, or a folder of images")->required()->type_name("VIDEO|FOLDER");
  addBoardOption(command, choice->board, "as the sheet says").capture_default_str();
  command.add_option("--setup", choice->setup, "Write this setup with the lens in it")->type_name("SETUP.json");
  command.add_option("--feed", choice->feed, "The feed of the setup that has it")->type_name("NAME");
  addOutputOption(command, choice->output, "The lens, or the setup with it", {".json"});
  context.finish(command,
                 "  ocelli feeds calibrate lens views.mp4 -o lens.json\n"
                 "  ocelli feeds calibrate lens views/ --board 9x6:25 --setup setup.json --feed left -o setup.json",
                 [choice, context, work] { work(*choice, context); });
}

void addPose(CLI::App& calibrate, const CommandContext& context, const FeedsWorkOf<FeedsPoseChoice>& work) {
  CLI::App& command = *calibrate.add_subcommand("pose", "Find where cameras stand, from tags that they see");
  const auto choice = std::make_shared<FeedsPoseChoice>();
  addPlacesOptions(command, choice->setup, choice->places, "Tags at known places, and corners that were clicked")
      ->required();
  addOutputOption(command, choice->output, "The setup with poses", {".json"});
  command.add_flag("--without-lens", choice->options.hasNoLens,
                   "Find a focal length, too: 6 points or more, not in a plane");
  context.finish(command, "  ocelli feeds calibrate pose setup.json --places places.json -o setup.json",
                 [choice, context, work] { work(*choice, context); });
}

void addCheck(CLI::App& calibrate, const CommandContext& context, const FeedsWorkOf<FeedsCheckChoice>& work) {
  CLI::App& command = *calibrate.add_subcommand("check", "Say whether cameras have moved");
  const auto choice = std::make_shared<FeedsCheckChoice>();
  addPlacesOptions(command, choice->setup, choice->places, "Tags at known places; those in the setup by default");
  command.add_option("--moved", choice->movedPixels, "From how far on")
      ->check(numberCheck(0.1, 1000))
      ->capture_default_str()
      ->type_name("PIXELS");
  context.finish(command,
                 "  ocelli feeds calibrate check setup.json\n"
                 "  ocelli feeds calibrate check setup.json --places places.json --moved 5",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace

void addFeedsCalibrateCommand(CLI::App& feeds, const CommandContext& context, const FeedsWork& work) {
  CLI::App& calibrate =
      *feeds.add_subcommand("calibrate", "Find lenses and poses of cameras; print boards and tags for it");
  addUsualSheet(calibrate, context, work.sheet);
  addSheet(calibrate, context, work.sheet);
  addLens(calibrate, context, work.lens);
  addPose(calibrate, context, work.pose);
  addCheck(calibrate, context, work.check);
}

}  // namespace ocelli
