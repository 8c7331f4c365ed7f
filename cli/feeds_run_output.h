// Where the images of `ocelli feeds run` go: a video or a folder, a page, and whoever watches.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/feeds_work.h"
#include "oc_core/feeds_live/run_pace.h"
#include "oc_core/feeds_video/video_writer.h"

namespace ocelli {

class FeedsPage;

/// Who watches a run and may change it: the window. Without one all are empty.
struct RunWatcher {
  std::function<void(const ComposedFrame& frame)> show;  ///< gets images without labels
  std::function<ErasedLook()> erased;
  std::function<bool()> isClosed;
};

/// Throws InputError where what is written would replace the video of a feed.
void checkIsNoFeed(const std::filesystem::path& output, const FeedSetup& setup);

/// Says of each feed that is lost why it is, as it happens.
std::function<void(size_t feed, const std::string& message)> noteLostFeeds(const FeedSetup& setup,
                                                                           const CommandContext& context);

/// An error message as further lines of a table, each begun with `indent`.
std::string indentedLines(const std::string& message, const std::string& indent);

class FeedsRunOutput {
 public:
  /// Throws InputError where this program was built without what is asked for, WorkError where it cannot be written.
  FeedsRunOutput(const FeedsRunChoice& choice, const FeedSetup& setup, const RunWatcher& watcher,
                 const CommandContext& context);
  ~FeedsRunOutput();
  FeedsRunOutput(const FeedsRunOutput&) = delete;
  FeedsRunOutput& operator=(const FeedsRunOutput&) = delete;

  /// Waits until it is time for the image where somebody watches.
  void add(const ComposedFrame& frame);
  void finish(const CommandContext& context);

 private:
  std::filesystem::path frameFile(size_t frame) const;
  void openPage(int port, const std::string& title, const CommandContext& context);
  void showOnPage(const ComposedFrame& frame, const Image<Rgb8>& image);

  const RunWatcher& watcher_;
  bool drawsLabels_;  ///< into the images that are kept: those that come have none
  std::filesystem::path path_;
  std::unique_ptr<VideoWriter> video_;
  std::unique_ptr<FeedsPage> page_;
  size_t frames_ = 0;
  double firstSeconds_ = 0;
  RunPace pace_;
};

}  // namespace ocelli
