// The work of `ocelli feeds run`.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/feeds_video/video_writer.h"
#ifdef OCELLI_WITH_LIVE_PAGE
#include "oc_core/feeds_page/feeds_page.h"
#endif

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

FeedsJson jsonOf(const FeedsRunFigures& figures, const std::vector<std::optional<double>>& movedPixels) {
  FeedsJson feeds = FeedsJson::array();
  for (size_t i = 0; i < figures.feeds.size(); ++i) {
    const FeedRunFigures& feed = figures.feeds[i];
    feeds.push_back({{"name", feed.name},
                     {"state", wordOf(feed.state)},
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

/// Says which cameras have moved since their poses were found, by the first frame of each feed.
class StartPoseCheck {
 public:
  StartPoseCheck(const FeedsRunChoice& choice, const FeedSetup& setup, const CommandContext& context)
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

/// Where the images go: a video or a folder, and a page.
class RunOutput {
 public:
  RunOutput(const FeedsRunChoice& choice, const FeedSetup& setup, const CommandContext& context)
      : path_(choice.output), began_(std::chrono::steady_clock::now()) {
    if (choice.output.empty() && !choice.page) {
      throw InputError("there is nowhere for the image to go", "-o", "give -o corridor.mp4, --page 8765, or both");
    }
    const std::filesystem::path ending = path_.extension();
    if (ending == ".mp4" || ending == ".mkv") {
      video_ = std::make_unique<VideoWriter>(path_, setup.output.width, setup.output.height,
                                             VideoWriterOptions{choice.options.framesPerSecond, 20, false});
    } else if (!path_.empty()) {
      makeFolder(path_);
    }
    if (choice.page) {
      openPage(*choice.page, choice.setup, context);
    }
  }

  void add(const ComposedFrame& frame) {
    firstSeconds_ = frames_ == 0 ? frame.seconds : firstSeconds_;
    const double seconds = frame.seconds - firstSeconds_;
    if (video_) {
      video_->add(frame.image, seconds);
    } else if (!path_.empty()) {
      writePng(path_ / fmt::format("frame-{:06}.png", frames_), frame.image);
    }
    show(frame, seconds);
    ++frames_;
  }

  void finish(const CommandContext& context) {
    if (video_) {
      video_->finish();
    }
    if (!path_.empty()) {
      context.note(fmt::format("wrote {} ({} frames)", path_.string(), frames_));
    }
  }

 private:
#ifdef OCELLI_WITH_LIVE_PAGE
  void openPage(int port, const std::string& title, const CommandContext& context) {
    page_ = std::make_unique<FeedsPage>(port, title);
    context.note("page " + page_->address());
  }

  void show(const ComposedFrame& frame, double seconds) {
    if (!page_) {
      return;
    }
    std::vector<std::string> feeds;
    for (size_t i = 0; i < frame.labels.size(); ++i) {
      feeds.push_back(feedLabelText(frame.composer.graph().setup().frusta[i].feed, frame.labels[i]));
    }
    page_->show(frame.image, feeds);
    // People watch: recorded feeds go on no faster than they were taken.
    began_ = frames_ == 0 ? std::chrono::steady_clock::now() : began_;
    std::this_thread::sleep_until(began_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(seconds)));
  }

  std::unique_ptr<FeedsPage> page_;
#else
  [[noreturn]] static void openPage(int /*port*/, const std::string& /*title*/, const CommandContext& /*context*/) {
    throw InputError("this program was built without pages", "--page",
                     "build it with -DOCELLI_WITH_LIVE_PAGE=ON (docs/install.md)");
  }
  void show(const ComposedFrame& /*frame*/, double /*seconds*/) {}
#endif

  std::filesystem::path path_;
  std::unique_ptr<VideoWriter> video_;
  size_t frames_ = 0;
  double firstSeconds_ = 0;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace

void runFeedsCommand(const FeedsRunChoice& choice, const CommandContext& context) {
  checkFiguresOutput(choice.json, choice.output);
  const FeedSetup setup = readFeedSetup(choice.setup);
  FeedsRunOptions options = choice.options;
  options.erased = choice.erased == "red" ? ErasedLook::kRed : ErasedLook::kBackground;
  options.hasLabels = !choice.hasNoLabels;
  RunOutput output(choice, setup, context);
  // Live feeds have no end: Ctrl-C is one, and what was made until then is finished.
  const InterruptGuard guard;
  options.isStopped = InterruptGuard::interrupted;
  StartPoseCheck poses(choice, setup, context);
  if (poses.isWanted()) {
    options.remarkOn = std::ref(poses);
  }
  const FeedsRunFigures figures = runFeeds(
      setup, options, [&](const ComposedFrame& frame) { output.add(frame); }, context.progress());
  if (InterruptGuard::interrupted() && !figures.isLive && !choice.output.empty()) {
    throw WorkError("interrupted: it is not finished", choice.output, "the same command again");
  }
  context.clearProgress();
  output.finish(context);
  giveFigures(choice.json, textOfJson(jsonOf(figures, poses.movedPixels()), 2) + "\n", tableOf(figures), context);
}

}  // namespace ocelli
