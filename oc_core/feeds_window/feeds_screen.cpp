#include "oc_core/feeds_window/feeds_screen.h"

#include <utility>

namespace ocelli {

void FeedsScreen::show(const ComposedFrame& frame) {
  std::unique_lock lock(mutex_);
  firstSeconds_ = firstSeconds_.value_or(frame.seconds);
  newest_ = ShownFeeds{frame.image, frame.labels, frame.seconds - *firstSeconds_};
  if (woken_) {
    woken_();
  }
  changed_.wait(lock, [&] { return !isPaused_ || isClosed_ || steps_ > 0; });
  steps_ -= steps_ > 0 ? 1 : 0;
}

ErasedLook FeedsScreen::erased() const {
  const std::lock_guard lock(mutex_);
  return erased_;
}

bool FeedsScreen::isClosed() const {
  const std::lock_guard lock(mutex_);
  return isClosed_;
}

void FeedsScreen::end() {
  const std::lock_guard lock(mutex_);
  hasEnded_ = true;
  if (woken_) {
    woken_();
  }
}

std::optional<ShownFeeds> FeedsScreen::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(newest_, std::nullopt);
}

bool FeedsScreen::hasEnded() const {
  const std::lock_guard lock(mutex_);
  return hasEnded_;
}

bool FeedsScreen::isPaused() const {
  const std::lock_guard lock(mutex_);
  return isPaused_;
}

void FeedsScreen::setPaused(bool paused) {
  const std::lock_guard lock(mutex_);
  isPaused_ = paused && !isLive_;
  steps_ = 0;
  changed_.notify_all();
}

void FeedsScreen::step() {
  const std::lock_guard lock(mutex_);
  steps_ += isPaused_ ? 1 : 0;
  changed_.notify_all();
}

void FeedsScreen::setErased(ErasedLook erased) {
  const std::lock_guard lock(mutex_);
  erased_ = erased;
  steps_ += isPaused_ ? 1 : 0;  // so that it is seen
  changed_.notify_all();
}

void FeedsScreen::close() {
  const std::lock_guard lock(mutex_);
  isClosed_ = true;
  changed_.notify_all();
}

}  // namespace ocelli
