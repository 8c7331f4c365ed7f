// Compares every frame that an emulated display acknowledges with the one that was submitted under its number.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>

#include "display_driver/firmware/refresh_sink.h"

namespace ocelli {

class ArrivalCheck : public ArrivalSink {
 public:
  /// Call it before the frame with this number is submitted.
  void expect(uint32_t frame, const Volume& volume) {
    const std::lock_guard lock(mutex_);
    submitted_.insert_or_assign(frame, volume);
  }

  void frameArrived(uint32_t /*session*/, uint32_t frame, const Volume& volume) override {
    const std::lock_guard lock(mutex_);
    const auto found = submitted_.find(frame);
    ++(found != submitted_.end() && found->second == volume ? right_ : wrong_);
    arrived_.notify_all();
  }

  size_t right() const { return count(right_); }
  size_t wrong() const { return count(wrong_); }
  bool waitForMore(size_t than, std::chrono::milliseconds timeout) const {
    std::unique_lock lock(mutex_);
    return arrived_.wait_for(lock, timeout, [&] { return right_ + wrong_ > than; });
  }

 private:
  size_t count(const size_t& counter) const {
    const std::lock_guard lock(mutex_);
    return counter;
  }

  mutable std::mutex mutex_;
  mutable std::condition_variable arrived_;
  std::map<uint32_t, Volume> submitted_;
  size_t right_ = 0;
  size_t wrong_ = 0;
};

}  // namespace ocelli
