// The work of `ocelli feeds run`.
#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/feeds_run_output.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/printable_text.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/feeds_window/feeds_window.h"
#include "oc_core/gl/gl_error.h"
#endif

namespace ocelli {
namespace {

using FeedsJson = nlohmann::ordered_json;

/// What was wrong with a feed at any time, and is not its state at the end.
std::vector<std::string> statesBefore(const FeedRunFigures& feed) {
  std::vector<std::string> words;
  const auto add = [&](bool was, FeedState state) {
    if (was && feed.state != state) {
      words.emplace_back(wordOf(state));
    }
  };
  add(feed.wasLate, FeedState::kLate);
  add(feed.wasFrozen, FeedState::kFrozen);
  add(feed.wasCovered, FeedState::kCovered);
  add(feed.wasLost, FeedState::kLost);
  return words;
}

FeedsJson jsonOf(const FeedsRunFigures& figures, const std::vector<std::optional<double>>& movedPixels) {
  FeedsJson feeds = FeedsJson::array();
  for (size_t i = 0; i < figures.feeds.size(); ++i) {
    const FeedRunFigures& feed = figures.feeds[i];
    feeds.push_back({{"name", feed.name},
                     {"state", wordOf(feed.state)},
                     {"states_before", statesBefore(feed)},
                     {"message", feed.message},
                     {"reconnections", feed.reconnections},
                     {"frames_read", feed.framesRead},
                     {"frames_skipped", feed.framesSkipped},
                     {"outputs_without_a_new_frame", feed.outputsWithout},
                     {"mean_age_seconds", feed.meanAgeSeconds},
                     {"max_age_seconds", feed.maxAgeSeconds},
                     {"moved_pixels", movedPixels[i] ? FeedsJson(*movedPixels[i]) : FeedsJson()}});
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
    table += fmt::format("  {:<12} {:>7} {:>7} {:>8} {:>7.0f} ms {:>7.0f} ms\n", printableText(feed.name),
                         wordOf(feed.state), feed.framesRead, feed.framesSkipped, 1e3 * feed.meanAgeSeconds,
                         1e3 * feed.maxAgeSeconds);
    if (const std::vector<std::string> before = statesBefore(feed); !before.empty()) {
      table += fmt::format("    for some time it was {}\n", fmt::join(before, ", "));
    }
    if (feed.reconnections > 0) {
      table += fmt::format("    lost, and back, {} times\n", feed.reconnections);
    }
    if (!feed.message.empty()) {
      table += indentedLines(feed.message, "    ") + "\n";
    }
  }
  return table;
}

/// Says which cameras have moved since their poses were found, by the first frame of each feed, and after it was lost.
class RunPoseCheck {
 public:
  RunPoseCheck(const FeedsRunChoice& choice, const FeedSetup& setup, const CommandContext& context)
      : choice_(choice), setup_(setup), context_(context), movedPixels_(setup.feeds.size()) {}

  bool isWanted() const { return choice_.checkPoses != "off" && !setup_.places.tags.empty(); }

  std::string operator()(size_t feed, const Image<Rgb8>& frame) {
    const PoseCheck check = checkPose(setup_, feed, frame, setup_.places);
    if (check.tags > 0) {
      movedPixels_[feed] = check.medianPixels;
    }
    if (check.hasMoved && choice_.checkPoses == "error") {
      throw WorkError(check.message, choice_.setup, "or go on with --check-poses warn");
    }
    if (check.hasMoved || (check.tags == 0 && check.shouldSeeTags)) {
      context_.clearProgress();
      context_.note("warning: " + check.message);
    }
    return check.hasMoved ? fmt::format("MOVED {:.0f} px", check.medianPixels) : "";
  }

  /// Of each feed; nothing where no tag was seen.
  const std::vector<std::optional<double>>& movedPixels() const { return movedPixels_; }

 private:
  const FeedsRunChoice& choice_;
  const FeedSetup& setup_;
  const CommandContext& context_;
  std::vector<std::optional<double>> movedPixels_;
};

FeedsRunFigures runWatched(const FeedsRunChoice& choice, const FeedSetup& setup, const CommandContext& context,
                           RunPoseCheck& poses, const RunWatcher& watcher) {
  FeedsRunOptions options = choice.options;
  options.erased = choice.erased == "red" ? ErasedLook::kRed : ErasedLook::kBackground;
  options.erasedNow = watcher.erased;
  options.hasLabels = !choice.hasNoLabels && !watcher.show;
  options.onLost = noteLostFeeds(setup, context);
  options.isStopped = [&] { return InterruptGuard::interrupted() || (watcher.isClosed && watcher.isClosed()); };
  if (poses.isWanted()) {
    options.remarkOn = std::ref(poses);
  }
  FeedsRunOutput output(choice, setup, watcher, context);
  FeedsRunFigures figures = runFeeds(
      setup, options, [&](const ComposedFrame& frame) { output.add(frame); }, context.progress());
  if (InterruptGuard::interrupted() && figures.frames == 0) {
    throw WorkError("interrupted before the first image", choice.setup, "the same command again");
  }
  if (InterruptGuard::interrupted() && !figures.isLive && !choice.output.empty()) {
    throw WorkError("interrupted: it is not finished", choice.output, "the same command again");
  }
  context.clearProgress();
  output.finish(context);
  return figures;
}

#ifdef OCELLI_WITH_OPENGL
FeedsRunFigures runInWindow(const FeedsRunChoice& choice, const FeedSetup& setup, const CommandContext& context,
                            RunPoseCheck& poses) {
  FeedsWindowOptions options;
  options.title = "Ocelli: " + choice.setup;
  options.isLive = mayBeLive(setup);
  options.hasRedErased = choice.erased == "red";
  options.hasLabels = !choice.hasNoLabels;
  options.goesOn = [] { return !InterruptGuard::interrupted(); };
  FeedsRunFigures figures;
  try {
    runFeedsWindow(FeedGraph(setup), options, [&](FeedsScreen& screen) {
      figures = runWatched(choice, setup, context, poses,
                           {.show = [&](const ComposedFrame& frame) { screen.show(frame); },
                            .erased = [&] { return screen.erased(); },
                            .isClosed = [&] { return screen.isClosed(); }});
    });
  } catch (const GlError& error) {
    throw WorkError(error.reason(), "--window", "set DISPLAY to a running X server, or use --page or -o without it");
  }
  return figures;
}
#else
[[noreturn]] FeedsRunFigures runInWindow(const FeedsRunChoice& /*choice*/, const FeedSetup& /*setup*/,
                                         const CommandContext& /*context*/, RunPoseCheck& /*poses*/) {
  throw InputError("this program was built without windows", "--window",
                   "build it with -DOCELLI_WITH_OPENGL=ON (docs/install.md)");
}
#endif

}  // namespace

void runFeedsCommand(const FeedsRunChoice& choice, const CommandContext& context) {
  checkFiguresOutput(choice.json, choice.output);
  if (choice.output.empty() && !choice.page && !choice.hasWindow) {
    throw InputError("there is nowhere for the image to go", "-o",
                     "give -o corridor.mp4, --window, --page 8765, or several of them");
  }
  const FeedSetup setup = readFeedSetup(choice.setup);
  // Live feeds have no end: Ctrl-C is one, and what was made until then is finished.
  const InterruptGuard guard;
  RunPoseCheck poses(choice, setup, context);
  const FeedsRunFigures figures =
      choice.hasWindow ? runInWindow(choice, setup, context, poses) : runWatched(choice, setup, context, poses, {});
  giveFigures(choice.json, textOfJson(jsonOf(figures, poses.movedPixels()), 2) + "\n", tableOf(figures), context);
}

}  // namespace ocelli
