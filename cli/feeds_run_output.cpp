#include "cli/feeds_run_output.h"

#include <fmt/format.h>

#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/printable_text.h"
#ifdef OCELLI_WITH_LIVE_PAGE
#include "oc_core/feeds_page/feeds_page.h"
#endif

namespace ocelli {

void checkIsNoFeed(const std::filesystem::path& output, const FeedSetup& setup) {
  for (const Feed& feed : setup.feeds) {
    std::error_code noFile;
    if (isFeedFile(feed.source) && std::filesystem::equivalent(output, feed.source, noFile)) {
      throw InputError("this is the video of the feed \"" + feed.name + "\"", output.string(), "write another file");
    }
  }
}

std::function<void(size_t feed, const std::string& message)> noteLostFeeds(const FeedSetup& setup,
                                                                           const CommandContext& context) {
  return [&setup, &context](size_t feed, const std::string& message) {
    context.clearProgress();
    context.note("warning: the feed \"" + printableText(setup.feeds[feed].name) + "\" is lost\n" +
                 indentedLines(message, "  "));
  };
}

std::string indentedLines(const std::string& message, const std::string& indent) {
  std::string lines = indent;
  for (const char c : message) {
    lines += c;
    lines += c == '\n' ? indent : "";
  }
  return lines;
}

FeedsRunOutput::FeedsRunOutput(const FeedsRunChoice& choice, const FeedSetup& setup, const RunWatcher& watcher,
                               const CommandContext& context)
    : watcher_(watcher), drawsLabels_(watcher.show && !choice.hasNoLabels), path_(choice.output) {
  checkIsNoFeed(path_, setup);
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

void FeedsRunOutput::add(const ComposedFrame& frame) {
  firstSeconds_ = frames_ == 0 ? frame.seconds : firstSeconds_;
  const double seconds = frame.seconds - firstSeconds_;
  Image<Rgb8> labelled;
  if (drawsLabels_ && (!path_.empty() || page_)) {
    labelled = frame.image;
    drawFeedLabels(frame.composer.graph(), frame.labels, labelled);
  }
  const Image<Rgb8>& image = labelled.empty() ? frame.image : labelled;
  if (video_) {
    video_->add(image, seconds);
  } else if (!path_.empty()) {
    writePng(frameFile(frames_), image);
  }
  ++frames_;
  if (page_ || watcher_.show) {
    std::this_thread::sleep_until(pace_.due(seconds, RunPace::Clock::now()));
  }
  showOnPage(frame, image);
  if (watcher_.show) {
    watcher_.show(frame);
  }
}

void FeedsRunOutput::finish(const CommandContext& context) {
  if (video_) {
    video_->finish();
  }
  if (!path_.empty()) {
    context.note(fmt::format("wrote {} ({} frames)", path_.string(), frames_));
  }
  if (!video_ && !path_.empty() && std::filesystem::exists(frameFile(frames_))) {
    context.note("warning: " + frameFile(frames_).string() + " and what follows are frames of an earlier run");
  }
}

std::filesystem::path FeedsRunOutput::frameFile(size_t frame) const {
  return path_ / fmt::format("frame-{:06}.png", frame);
}

#ifdef OCELLI_WITH_LIVE_PAGE
FeedsRunOutput::~FeedsRunOutput() = default;

void FeedsRunOutput::openPage(int port, const std::string& title, const CommandContext& context) {
  page_ = std::make_unique<FeedsPage>(port, title);
  context.note("page " + page_->address());
}

void FeedsRunOutput::showOnPage(const ComposedFrame& frame, const Image<Rgb8>& image) {
  if (!page_) {
    return;
  }
  std::vector<PageFeed> feeds;
  for (size_t i = 0; i < frame.labels.size(); ++i) {
    feeds.push_back({feedLabelText(frame.composer.graph().feedOf(i).name, frame.labels[i]), frame.labels[i].isGood()});
  }
  page_->show(image, feeds);
}
#else
class FeedsPage {};

FeedsRunOutput::~FeedsRunOutput() = default;

void FeedsRunOutput::openPage(int /*port*/, const std::string& /*title*/, const CommandContext& /*context*/) {
  throw InputError("this program was built without pages", "--page",
                   "build it with -DOCELLI_WITH_LIVE_PAGE=ON (docs/install.md)");
}

void FeedsRunOutput::showOnPage(const ComposedFrame& /*frame*/, const Image<Rgb8>& /*image*/) {}
#endif

}  // namespace ocelli
