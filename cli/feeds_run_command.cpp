// `ocelli feeds run`: the image of a graph camera from its feeds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/feeds_command.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/feeds_live/feeds_run.h"
#include "oc_core/feeds_video/video_writer.h"

namespace ocelli {
namespace {

using FeedsJson = nlohmann::ordered_json;

struct FeedsRunChoice {
  std::string setup;
  std::string output;
  std::string erased = "background";
  bool hasNoLabels = false;
  FeedsRunOptions options;
  std::string json;
};

const char* wordOf(FeedState state) {
  switch (state) {
    case FeedState::kLive:
      return "live";
    case FeedState::kLate:
      return "late";
    case FeedState::kFrozen:
      return "frozen";
    case FeedState::kEnded:
      return "ended";
    case FeedState::kLost:
      return "lost";
  }
  return "";
}

FeedsJson jsonOf(const FeedsRunFigures& figures) {
  FeedsJson feeds = FeedsJson::array();
  for (const FeedRunFigures& feed : figures.feeds) {
    feeds.push_back({{"name", feed.name},
                     {"state", wordOf(feed.state)},
                     {"message", feed.message},
                     {"frames_read", feed.framesRead},
                     {"frames_skipped", feed.framesSkipped},
                     {"outputs_without_a_new_frame", feed.outputsWithout},
                     {"mean_age_seconds", feed.meanAgeSeconds},
                     {"max_age_seconds", feed.maxAgeSeconds}});
  }
  return {{"frames", figures.frames},
          {"wall_seconds", figures.wallSeconds},
          {"frames_per_second", figures.framesPerSecond},
          {"mean_frame_seconds", figures.meanFrameSeconds},
          {"slowest_frame_seconds", figures.slowestFrameSeconds},
          {"feeds", feeds}};
}

std::string tableOf(const FeedsRunFigures& figures) {
  std::string table = fmt::format(
      "  frames       {}, {:.1f} a second\n  delay        {:.1f} ms from the feeds' frames to the image, {:.1f} at "
      "most\n\n  {:<12} {:>7} {:>7} {:>8} {:>10} {:>10}\n",
      figures.frames, figures.framesPerSecond, 1e3 * figures.meanFrameSeconds, 1e3 * figures.slowestFrameSeconds,
      "feed", "state", "frames", "skipped", "mean age", "oldest");
  for (const FeedRunFigures& feed : figures.feeds) {
    table += fmt::format("  {:<12} {:>7} {:>7} {:>8} {:>7.0f} ms {:>7.0f} ms\n", feed.name, wordOf(feed.state),
                         feed.framesRead, feed.framesSkipped, 1e3 * feed.meanAgeSeconds, 1e3 * feed.maxAgeSeconds);
    if (!feed.message.empty()) {
      table += "    " + feed.message + "\n";
    }
  }
  return table;
}

void runFeedsCommand(FeedsRunChoice choice, const CommandContext& context) {
  checkFiguresOutput(choice.json, choice.output);
  const FeedSetup setup = readFeedSetup(choice.setup);
  choice.options.erased = choice.erased == "red" ? ErasedLook::kRed : ErasedLook::kBackground;
  choice.options.hasLabels = !choice.hasNoLabels;
  const std::filesystem::path output(choice.output);
  const bool isVideo = output.extension() == ".mp4" || output.extension() == ".mkv";
  std::unique_ptr<VideoWriter> video;
  if (isVideo) {
    video = std::make_unique<VideoWriter>(output, setup.output.width, setup.output.height,
                                          VideoWriterOptions{choice.options.framesPerSecond, 20, false});
  } else {
    makeFolder(output);
  }
  size_t frames = 0;
  const auto write = [&](const ComposedFrame& frame) {
    if (video) {
      video->add(frame.image, static_cast<double>(frames) / choice.options.framesPerSecond);
    } else {
      writePng(output / fmt::format("frame-{:06}.png", frames), frame.image);
    }
    ++frames;
  };
  const FeedsRunFigures figures = runFeeds(setup, choice.options, write, context.progress());
  if (video) {
    video->finish();
  }
  context.clearProgress();
  context.note(fmt::format("wrote {} ({} frames)", choice.output, frames));
  giveFigures(choice.json, textOfJson(jsonOf(figures), 2) + "\n", tableOf(figures), context);
}

}  // namespace

void addFeedsRunCommand(CLI::App& feeds, const CommandContext& context) {
  CLI::App& command = *feeds.add_subcommand("run", "Compose the image of a graph camera from its feeds");
  const auto choice = std::make_shared<FeedsRunChoice>();
  command.add_option("SETUP", choice->setup, "The feeds and their frusta")->required()->type_name("SETUP.json");
  command.add_option("-o,--output", choice->output, "A video (.mp4, .mkv), or a folder for images")
      ->required()
      ->type_name("FILE.mp4|FOLDER");
  FeedsRunOptions& options = choice->options;
  command.add_option("--seconds", options.seconds, "How long; until the last feed ends by default")
      ->check(numberCheck(1e-3, 1e9))
      ->type_name("S");
  command.add_option("--frames-per-second", options.framesPerSecond, "Of the image")
      ->check(numberCheck(1, 240))
      ->capture_default_str()
      ->type_name("F");
  command.add_option("--erased", choice->erased, "How pixels look from which a subject was erased: they are not live")
      ->check(CLI::IsMember({"background", "red"}))
      ->capture_default_str();
  command.add_option("--wait", options.streams.maxWaitSeconds, "How long a feed is waited for, once")
      ->check(numberCheck(0, 3600))
      ->capture_default_str()
      ->type_name("S");
  command.add_flag("--no-labels", choice->hasNoLabels, "Leave out the time of each feed");
  addFiguresOption(command, choice->json);
  context.finish(command,
                 "  ocelli feeds run corridor/setup.json -o corridor.mp4\n"
                 "  ocelli feeds run corridor/setup.json --erased red --seconds 10 -o frames/ --json figures.json",
                 [choice, context] { runFeedsCommand(*choice, context); });
}

}  // namespace ocelli
