#include "display_driver/device/frame_fence.h"

namespace ocelli {

bool hasEnded(FrameStage stage) {
  return stage == FrameStage::kShown || stage == FrameStage::kDropped || stage == FrameStage::kLost;
}

FrameState FrameFence::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

FrameState FrameFence::wait(FrameStage stage, std::chrono::microseconds timeout) const {
  std::unique_lock lock(mutex_);
  moved_.wait_for(lock, timeout, [&] { return hasEnded(state_.stage) || state_.stage >= stage; });
  return state_;
}

void FrameFence::moveTo(const FrameState& state) {
  const std::lock_guard lock(mutex_);
  if (!hasEnded(state_.stage)) {
    state_ = state;
    moved_.notify_all();
  }
}

}  // namespace ocelli
