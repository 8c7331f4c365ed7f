// The work of `ocelli feeds panes`.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/feeds_run_output.h"
#include "cli/interrupt.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/feeds_live/feed_panes.h"
#include "oc_core/feeds_video/video_writer.h"

namespace ocelli {

void showPanesCommand(const FeedsPanesChoice& choice, const CommandContext& context) {
  const FeedSetup setup = readFeedSetup(choice.setup);
  const std::filesystem::path path = choice.output;
  checkIsNoFeed(path, setup);
  FeedsRunOptions options;
  options.onLost = noteLostFeeds(setup, context);
  options.seconds = choice.seconds;
  options.hasLabels = false;
  std::optional<VideoWriter> video;
  if (path.extension() == ".png") {
    checkWritable(path);
  } else {
    video.emplace(path, setup.output.width, setup.output.height,
                  VideoWriterOptions{.framesPerSecond = options.framesPerSecond});
  }
  const InterruptGuard guard;
  options.isStopped = InterruptGuard::interrupted;
  Image<Rgb8> image;
  double firstSeconds = 0;
  size_t frames = 0;
  const FeedsRunFigures figures = runFeeds(
      setup, options,
      [&](const ComposedFrame& frame) {
        firstSeconds = frames == 0 ? frame.seconds : firstSeconds;
        ++frames;
        drawFeedPanes(frame.composer, frame.labels, image);
        if (video) {
          video->add(image, frame.seconds - firstSeconds);
        }
      },
      context.progress());
  if (InterruptGuard::interrupted() && (!figures.isLive || frames == 0)) {
    throw WorkError("interrupted: it is not finished", choice.output, "the same command again");
  }
  context.clearProgress();
  if (video) {
    video->finish();
  } else {
    writePng(path, image);
  }
  context.note(fmt::format("wrote {} ({} frames)", choice.output, frames));
}

}  // namespace ocelli
