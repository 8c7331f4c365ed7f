// `ocelli feeds calibrate`: sheets to print, lenses, poses, and whether cameras have moved.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/feeds_calibration/calibrate_feeds.h"
#include "oc_core/feeds_calibration/calibration_sheet.h"

namespace ocelli {
namespace {

struct CalibrateChoice {
  std::string source;
  std::string output;
  std::string board = textOf(CalibrationBoard{});
  std::string setup;
  std::string feed;
  std::string tags;
  std::string paper = "a4";
  std::vector<int> ids;
  double tagMillimetres = 160;
  double movedPixels = kMovedPixels;
  PoseCalibrationOptions poses;
};

/// A setup that is written beside another: its files stay those that they were.
void writeSetup(FeedSetup setup, const std::string& output) {
  const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
  for (Feed& feed : setup.feeds) {
    for (std::string* file : {&feed.source, &feed.background}) {
      if (!file->empty() && file->find("://") == std::string::npos) {
        *file = std::filesystem::absolute(*file).lexically_proximate(folder).string();
      }
    }
  }
  writeFile(output, jsonText(setup));
}

void runSheet(const CalibrateChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const SheetPaper paper = paperFromText(choice.paper);
  writeFile(choice.output, choice.ids.empty() ? boardSheetPdf(boardFromText(choice.board), paper)
                                              : tagSheetPdf(choice.ids, choice.tagMillimetres, paper));
  context.note("wrote " + choice.output + ": print it at 100 % and measure its ruler");
}

void runLens(const CalibrateChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  if (choice.setup.empty() != choice.feed.empty()) {
    throw InputError("--setup and --feed go together", "feeds calibrate lens", "give both, or neither");
  }
  const CalibrationBoard board = boardFromText(choice.board);
  FeedSetup setup;
  if (!choice.setup.empty()) {
    setup = readFeedSetup(choice.setup);
    if (setup.feedIndex(choice.feed) < 0) {
      throw InputError("there is no feed \"" + choice.feed + "\"", choice.setup, "use the name of one of its feeds");
    }
  }
  const LensCalibration result = calibrateLensFrom(choice.source, board, context.progress());
  context.clearProgress();
  if (choice.setup.empty()) {
    writeFile(choice.output, jsonText(result.lens));
  } else {
    Feed& feed = setup.feeds[static_cast<size_t>(setup.feedIndex(choice.feed))];
    if (feed.width != result.width || feed.height != result.height) {
      throw InputError(fmt::format("the views have {}x{} pixels, and feed \"{}\" has {}x{}", result.width,
                                   result.height, feed.name, feed.width, feed.height),
                       choice.source, "take views of the board with the size of the feed");
    }
    feed.lens = result.lens;
    writeSetup(setup, choice.output);
  }
  context.print(fmt::format(
      "  focal        {:.2f} x {:.2f} pixels, known to {:.2f} %\n  center       {:.2f}, {:.2f}\n"
      "  error        {:.3f} pixels RMS\n  views        {}, and {} left out\n"
      "  covered      {:.0f} % of the image\n  tilt         {:.0f} degrees between views\n",
      result.lens.focal.x, result.lens.focal.y, 100 * result.focalSpread, result.lens.center.x, result.lens.center.y,
      result.rmsPixels, result.views, result.viewsLeftOut, 100 * result.coveredShare, result.maxTiltDegrees));
  for (const std::string& warning : result.warnings) {
    context.note("warning: " + warning);
  }
  context.note("wrote " + choice.output);
}

void runPose(const CalibrateChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  FeedSetup setup = readFeedSetup(choice.setup);
  const PoseCalibration result =
      calibratePoses(setup, readKnownPlaces(choice.tags), choice.tags, choice.poses, context.progress());
  context.clearProgress();
  writeSetup(setup, choice.output);
  std::string table =
      fmt::format("  {:<12} {:>5} {:>7} {:>11} {:>11}  worst at\n", "feed", "tags", "points", "RMS pixels", "worst");
  for (const FeedCalibration& feed : result.feeds) {
    table += fmt::format("  {:<12} {:>5} {:>7} {:>11.3f} {:>11.3f}  {}\n", feed.feed, feed.tags, feed.points,
                         feed.rmsPixels, feed.maxPixels, feed.worst);
  }
  context.print(table);
  for (const std::string& warning : result.warnings) {
    context.note("warning: " + warning);
  }
  context.note("wrote " + choice.output);
}

void runCheck(const CalibrateChoice& choice, const CommandContext& context) {
  const FeedSetup setup = readFeedSetup(choice.setup);
  std::string table = fmt::format("  {:<12} {:>5} {:>13}\n", "feed", "tags", "median pixels");
  std::string moved;
  for (const PoseCheck& check : checkPoses(setup, readKnownPlaces(choice.tags), choice.movedPixels, choice.poses)) {
    table += fmt::format("  {:<12} {:>5} {:>13.2f}\n", check.feed, check.tags, check.medianPixels);
    if (check.hasMoved) {
      moved += (moved.empty() ? "" : "; ") + check.message;
    } else if (!check.message.empty()) {
      context.note("warning: " + check.message);
    }
  }
  context.print(table);
  if (!moved.empty()) {
    throw WorkError(moved, choice.setup, "put cameras back, or run `ocelli feeds calibrate pose` for new poses");
  }
}

CLI::App& addPart(CLI::App& calibrate, const char* name, const char* help) {
  return *calibrate.add_subcommand(name, help);
}

void addTagsOption(CLI::App& command, CalibrateChoice& choice) {
  command.add_option("SETUP", choice.setup, "The feeds")->required()->type_name("SETUP.json");
  command.add_option("--places", choice.tags, "Tags at known places, and corners that were clicked")
      ->required()
      ->type_name("PLACES.json");
}

void addBoardOption(CLI::App& command, CalibrateChoice& choice) {
  command.add_option("--board", choice.board, "COLUMNSxROWS:SQUARE:MARKER:DICTIONARY in mm, as the sheet says")
      ->capture_default_str()
      ->type_name("BOARD");
}

}  // namespace

void addFeedsCalibrateCommand(CLI::App& feeds, const CommandContext& context) {
  CLI::App& calibrate =
      *feeds.add_subcommand("calibrate", "Find lenses and poses of cameras; print boards and tags for it");
  calibrate.require_subcommand(1);
  const auto choice = std::make_shared<CalibrateChoice>();

  CLI::App& sheet = addPart(calibrate, "sheet", "Print a board, or tags, as PDF");
  addOutputOption(sheet, choice->output, "The sheet", {".pdf"});
  addBoardOption(sheet, *choice);
  sheet.add_option("--tags", choice->ids, "AprilTags 36h11 of these numbers, instead of a board")
      ->check(CLI::Range(0, static_cast<int>(kMaxKnownTags) - 1))
      ->delimiter(',')
      ->type_name("N,N,...");
  sheet.add_option("--tag-size", choice->tagMillimetres, "Side of the black square")
      ->check(numberCheck(5, 2000))
      ->capture_default_str()
      ->type_name("MM");
  sheet.add_option("--paper", choice->paper, "a4 to a0, lying, or WIDTHxHEIGHT in mm")->capture_default_str();
  context.finish(sheet,
                 "  ocelli feeds calibrate sheet -o board.pdf\n"
                 "  ocelli feeds calibrate sheet --tags 0,1,2,3 --tag-size 150 --paper a3 -o tags.pdf",
                 [choice, context] { runSheet(*choice, context); });

  CLI::App& lens = addPart(calibrate, "lens", "Find a lens from views of a board");
  lens.add_option("VIEWS", choice->source, "A video, or a folder of images")->required()->type_name("VIDEO|FOLDER");
  addBoardOption(lens, *choice);
  lens.add_option("--setup", choice->setup, "Write this setup with the lens in it")->type_name("SETUP.json");
  lens.add_option("--feed", choice->feed, "The feed of the setup that has it")->type_name("NAME");
  addOutputOption(lens, choice->output, "The lens, or the setup with it", {".json"});
  context.finish(lens,
                 "  ocelli feeds calibrate lens views.mp4 -o lens.json\n"
                 "  ocelli feeds calibrate lens views/ --board 9x6:25 --setup setup.json --feed left -o setup.json",
                 [choice, context] { runLens(*choice, context); });

  CLI::App& pose = addPart(calibrate, "pose", "Find where cameras stand, from tags that they see");
  addTagsOption(pose, *choice);
  addOutputOption(pose, choice->output, "The setup with poses", {".json"});
  pose.add_flag("--without-lens", choice->poses.hasNoLens,
                "Find a focal length, too: 6 points or more, not in a plane");
  context.finish(pose, "  ocelli feeds calibrate pose setup.json --places places.json -o setup.json",
                 [choice, context] { runPose(*choice, context); });

  CLI::App& check = addPart(calibrate, "check", "Say whether cameras have moved");
  addTagsOption(check, *choice);
  check.add_option("--moved", choice->movedPixels, "From how far on")
      ->check(numberCheck(0.1, 1000))
      ->capture_default_str()
      ->type_name("PIXELS");
  context.finish(check, "  ocelli feeds calibrate check setup.json --places places.json",
                 [choice, context] { runCheck(*choice, context); });
}

}  // namespace ocelli
