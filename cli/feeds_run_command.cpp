// `ocelli feeds run`: the image of a graph camera from its feeds.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"

namespace ocelli {
namespace {

/// Empty where a run can write there: a folder by the name of another kind of video would be a surprise.
std::string checkRunOutput(const std::string& given) {
  const std::filesystem::path path = given;
  std::error_code ignored;
  const bool isFolder = !path.has_extension() || !path.has_filename() || std::filesystem::is_directory(path, ignored);
  return isFolder || path.extension() == ".mp4" || path.extension() == ".mkv"
             ? std::string()
             : "\"" + given + "\" ends neither in .mp4 nor in .mkv, and is no folder";
}

}  // namespace

void addHiddenOption(CLI::App& command, bool& showsHidden) {
  command.add_flag("!--no-hidden", showsHidden,
                   "Do not show those who are hidden by somebody erased as they were seen last");
}

void addFeedsRunCommand(CLI::App& feeds, const CommandContext& context, const FeedsWorkOf<FeedsRunChoice>& work) {
  CLI::App& command = *feeds.add_subcommand("run", "Compose the image of a graph camera from its feeds");
  const auto choice = std::make_shared<FeedsRunChoice>();
  command.add_option("SETUP", choice->setup, "The feeds and their frusta")->required()->type_name("SETUP.json");
  command
      .add_option("-o,--output", choice->output,
                  "A video (.mp4, .mkv), or a folder for images; one that is to be made and has a dot ends in /")
      ->check(checkRunOutput)
      ->type_name("FILE.mp4|FILE.mkv|FOLDER");
  command
      .add_option("--page", choice->page,
                  "Show the image as it is made on a page at this port of 127.0.0.1; 0 takes a free one")
      ->check(CLI::Range(0, 65535))
      ->type_name("PORT");
  command.add_flag("--window", choice->hasWindow, "Show the image as it is made in a window; its keys: H");
  FeedsRunOptions& options = choice->options;
  command
      .add_option("--seconds", options.seconds,
                  "How long; by default until the last feed ends, or Ctrl-C where some are live")
      ->check(numberCheck(1e-3, 1e9))
      ->type_name("S");
  command.add_option("--frames-per-second", options.framesPerSecond, "Of the image")
      ->check(numberCheck(1, 240))
      ->capture_default_str()
      ->type_name("F");
  command.add_option("--erased", choice->erased, "How pixels look from which a subject was erased: they are not live")
      ->check(CLI::IsMember({"background", "red"}))
      ->capture_default_str();
  addHiddenOption(command, options.showsHidden);
  command.add_option("--wait", options.streams.maxWaitSeconds, "How long a feed is waited for, once")
      ->check(numberCheck(0, 3600))
      ->capture_default_str()
      ->type_name("S");
  command
      .add_option("--check-poses", choice->checkPoses,
                  "Where the setup has places of tags: what to do about cameras that have moved")
      ->check(CLI::IsMember({"warn", "error", "off"}))
      ->capture_default_str();
  command.add_flag("--no-labels", choice->hasNoLabels, "Leave out the time of each feed");
  addFiguresOption(command, choice->json);
  context.finish(command,
                 "  ocelli feeds run corridor/setup.json -o corridor.mp4\n"
                 "  ocelli feeds run corridor/setup.json --window\n"
                 "  ocelli feeds run corridor/setup.json --page 8765 -o corridor.mp4\n"
                 "  ocelli feeds run corridor/setup.json --erased red --seconds 10 -o frames/ --json figures.json",
                 [choice, context, work] { work(*choice, context); });
}

}  // namespace ocelli
