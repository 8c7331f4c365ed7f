#include "oc_core/feeds_live/first_frames.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/feeds_video/video_reader.h"

namespace ocelli {

std::vector<FirstFrame> firstFrames(const FeedSetup& setup, double maxWaitSeconds) {
  std::vector<FirstFrame> frames;
  for (const Feed& feed : setup.feeds) {
    FirstFrame& first = frames.emplace_back();
    try {
      const std::atomic<bool> stop{false};
      VideoReader reader({feed.source, feed.width, feed.height, feed.framesPerSecond, feed.ffmpegOptions},
                         maxWaitSeconds, stop);
      VideoFrame frame;
      if (!reader.next(frame)) {
        first.message = feed.source + ": there is no frame in it";
      } else if (frame.image.width() != feed.width || frame.image.height() != feed.height) {
        first.message = fmt::format("{}: it has {}x{} pixels, and the setup says {}x{}", feed.source,
                                    frame.image.width(), frame.image.height(), feed.width, feed.height);
      } else {
        first.image = std::move(frame.image);
      }
    } catch (const Error& error) {
      first.message = error.what();
    }
  }
  return frames;
}

}  // namespace ocelli
