// How far a submitted frame has come. Its device moves it on, anybody may wait for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace ocelli {

/// Counted by a device from 1 on.
using FrameNumber = uint32_t;

enum class FrameStage {
  kWaiting,  ///< taken, not sent yet
  kSending,
  kArrived,  ///< whole and right, as the device says
  kShown,
  kDropped,  ///< a newer frame took its place before it was shown
  kLost,     ///< damaged or cut off on the way, or the device is closed
};

struct FrameState {
  FrameStage stage = FrameStage::kWaiting;
  std::chrono::steady_clock::time_point sent{};     ///< its last byte; zero where that has not happened
  std::chrono::steady_clock::time_point arrived{};  ///< zero where it has not
  std::chrono::steady_clock::time_point shown{};    ///< when its first slice was shown
  uint64_t shownRefresh = 0;
  int shownSlice = 0;
  bool late = false;      ///< shown after its phase
  bool coarse = false;    ///< shown in part
  uint64_t bytes = 0;     ///< that were sent for it
  std::string problem{};  ///< of lost and dropped frames
};

/// Shown, dropped and lost frames stay what they are.
bool hasEnded(FrameStage stage);

class FrameFence {
 public:
  explicit FrameFence(FrameNumber number) : number_(number) {}

  FrameNumber number() const { return number_; }
  FrameState state() const;
  /// Until the frame has come this far, has ended otherwise, or the time is over.
  FrameState wait(FrameStage stage, std::chrono::microseconds timeout) const;

  /// For devices. A frame that has ended stays as it is.
  void moveTo(const FrameState& state);

 private:
  FrameNumber number_;
  mutable std::mutex mutex_;
  mutable std::condition_variable moved_;
  FrameState state_;
};

}  // namespace ocelli
