// What the thread that runs the feeds and the window that shows them tell each other: images in one direction, what the
// user wants in the other.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds_live/feeds_run.h"

namespace ocelli {

/// An image of the run, without texts in it.
struct ShownFeeds {
  Image<Rgb8> image;
  std::vector<FeedLabel> labels;  ///< of each frustum
  double seconds = 0;             ///< since the first image of the run
};

class FeedsScreen {
 public:
  /// `woken` is called on the thread of the run when there is something new. Live feeds cannot be paused.
  explicit FeedsScreen(bool isLive, std::function<void()> woken = {}) : isLive_(isLive), woken_(std::move(woken)) {}

  // For the thread of the run.

  /// Hands on an image, and waits while the user has paused the run. The window shows the newest one there is.
  void show(const ComposedFrame& frame);
  ErasedLook erased() const;
  /// The user has closed the window.
  bool isClosed() const;
  /// No image follows.
  void end();

  // For the window.

  /// The newest image, once.
  std::optional<ShownFeeds> take();
  bool isLive() const { return isLive_; }
  bool hasEnded() const;
  bool isPaused() const;
  void setPaused(bool paused);
  /// Lets one image through while it is paused.
  void step();
  void setErased(ErasedLook erased);
  void close();

 private:
  const bool isLive_;
  const std::function<void()> woken_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<ShownFeeds> newest_;
  std::optional<double> firstSeconds_;
  ErasedLook erased_ = ErasedLook::kBackground;
  bool isPaused_ = false;
  size_t steps_ = 0;
  bool isClosed_ = false;
  bool hasEnded_ = false;
};

}  // namespace ocelli
