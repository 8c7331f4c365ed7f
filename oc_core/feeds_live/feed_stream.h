// One feed on a thread of its own, aligned by its timestamps: frames wait in a short queue until the time of the place
// comes to them. A feed that stops holds nobody up for longer than once. A live one that breaks off is opened again.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_live/feed_state.h"
#include "oc_core/feeds_video/video_reader.h"

namespace ocelli {

struct FeedStreamOptions {
  double maxWaitSeconds = 2;      ///< how long a feed is waited for, once
  double maxSilenceSeconds = 10;  ///< after so long without an answer it is lost
  double frozenSeconds = 1;       ///< of frames that are all the same
  /// Whether the time of the place is now (feed_clock.h): nothing is waited for then.
  bool isLiveRun = false;
};

class FeedStream {
 public:
  /// Starts to read.
  FeedStream(const Feed& feed, const FeedStreamOptions& options);
  ~FeedStream();
  FeedStream(const FeedStream&) = delete;
  FeedStream& operator=(const FeedStream&) = delete;

  /// The time of the place of the first frame; nothing where none came in time.
  std::optional<double> firstSeconds();

  /// The newest frame until `seconds`, in the time of the place; nothing where there is none that was not yet taken.
  /// Waits until a later one is there, but at most as long as the options say, and once.
  std::optional<VideoFrame> take(double seconds);

  /// Whether frames may still come.
  bool isGoingOn() const;
  /// The time of the place of its end, where a recorded feed says it.
  std::optional<double> endSeconds() const;
  /// The time of the next frame, where one is there already.
  std::optional<double> nextSeconds() const;
  FeedState state() const;
  /// Why it is lost, as an error message.
  std::string message() const;
  /// Frames that were read, and those of them that were never taken, as others came too soon after them.
  size_t framesRead() const;
  size_t framesSkipped() const;
  /// How often a live feed broke off and came back.
  size_t reconnections() const;

 private:
  void read();
  bool readOnce(std::string& message);
  void add(VideoFrame frame, bool isLive);
  void noteChange(const VideoFrame& frame);
  bool waitUntilLater(std::unique_lock<std::mutex>& lock, double seconds);

  const Feed feed_;
  const FeedStreamOptions options_;
  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<VideoFrame> queue_;  ///< in the time of the place
  bool isOver_ = false;
  bool isBroken_ = false;  ///< a live one that will be opened again
  size_t reconnections_ = 0;
  bool isLate_ = false;
  std::string message_;
  size_t read_ = 0;
  size_t skipped_ = 0;
  std::vector<Rgb8> lastSamples_;  ///< of the last frame that was another one
  std::optional<double> sameSince_;
  double lastTaken_ = 0;
  std::optional<double> end_;
  std::thread thread_;
};

}  // namespace ocelli
