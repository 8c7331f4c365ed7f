// The work of `ocelli feeds run`.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/feeds_video/video_writer.h"

namespace ocelli {
namespace {

using FeedsJson = nlohmann::ordered_json;

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
                     {"reconnections", feed.reconnections},
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
    if (feed.reconnections > 0) {
      table += fmt::format("    lost, and back, {} times\n", feed.reconnections);
    }
    if (!feed.message.empty()) {
      table += "    " + feed.message + "\n";
    }
  }
  return table;
}

}  // namespace

void runFeedsCommand(const FeedsRunChoice& choice, const CommandContext& context) {
  checkFiguresOutput(choice.json, choice.output);
  const FeedSetup setup = readFeedSetup(choice.setup);
  FeedsRunOptions options = choice.options;
  options.erased = choice.erased == "red" ? ErasedLook::kRed : ErasedLook::kBackground;
  options.hasLabels = !choice.hasNoLabels;
  const std::filesystem::path output(choice.output);
  const bool isVideo = output.extension() == ".mp4" || output.extension() == ".mkv";
  std::unique_ptr<VideoWriter> video;
  if (isVideo) {
    video = std::make_unique<VideoWriter>(output, setup.output.width, setup.output.height,
                                          VideoWriterOptions{options.framesPerSecond, 20, false});
  } else {
    makeFolder(output);
  }
  size_t frames = 0;
  double first = 0;
  const auto write = [&](const ComposedFrame& frame) {
    first = frames == 0 ? frame.seconds : first;
    if (video) {
      video->add(frame.image, frame.seconds - first);
    } else {
      writePng(output / fmt::format("frame-{:06}.png", frames), frame.image);
    }
    ++frames;
  };
  // Live feeds have no end: Ctrl-C is one, and what was made until then is finished.
  const InterruptGuard guard;
  options.isStopped = InterruptGuard::interrupted;
  const FeedsRunFigures figures = runFeeds(setup, options, write, context.progress());
  if (InterruptGuard::interrupted() && !figures.isLive) {
    throw WorkError("interrupted: it is not finished", choice.output, "the same command again");
  }
  if (video) {
    video->finish();
  }
  context.clearProgress();
  context.note(fmt::format("wrote {} ({} frames)", choice.output, frames));
  giveFigures(choice.json, textOfJson(jsonOf(figures), 2) + "\n", tableOf(figures), context);
}

}  // namespace ocelli
