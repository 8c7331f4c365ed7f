#include "display_driver/device/ideal_device.h"

#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

// What a taker may be behind by before frames are lost.
constexpr size_t kMaxToTake = 4;

void lose(IdealScreen::Frame& frame, const std::string& problem) {
  frame.state.stage = FrameStage::kLost;
  frame.state.problem = problem;
  frame.state.shown = {};
  frame.fence->moveTo(frame.state);
}

}  // namespace

IdealDevice::IdealDevice(DeviceInfo info, const DisplayProfile& profile, std::unique_ptr<ShownFrames> frames)
    : info_(std::move(info)),
      profile_(profile),
      frames_(std::move(frames)),
      screen_(profile, std::chrono::steady_clock::now()) {
  counts_.connected = true;
  counts_.rotationsPerMinute = profile.rotationsPerMinute;
  thread_ = std::thread([this] { run(); });
}

IdealDevice::~IdealDevice() {
  end();
}

std::shared_ptr<const FrameFence> IdealDevice::submitFrame(std::shared_ptr<const Volume> volume,
                                                           std::optional<std::span<const int>>) {
  OC_CHECK(volume->profile() == profile_, "a volume of another display was submitted");
  IdealScreen::Frame frame;
  if (frames_ != nullptr) {
    frame.volume = std::move(volume);
  }
  const std::lock_guard lock(mutex_);
  frame.fence = std::make_shared<FrameFence>(++lastNumber_);
  ++counts_.framesSubmitted;
  const auto fence = frame.fence;
  if (failure_) {
    ++counts_.framesLost;
    lose(frame, counts_.lastProblem);
    return fence;
  }
  advance();
  ++counts_.framesArrived;
  screen_.add(std::move(frame), std::chrono::steady_clock::now());
  return fence;
}

void IdealDevice::present(FrameNumber frame, const Presentation& presentation) {
  OC_CHECK(!presentation.at || (presentation.at->slice >= 0 && presentation.at->slice < profile_.storedSlices()),
           "a frame cannot be shown at a slice that the display does not have");
  const std::lock_guard lock(mutex_);
  advance();
  screen_.present(frame, presentation, std::chrono::steady_clock::now());
  changed_.notify_all();
}

Telemetry IdealDevice::telemetry() {
  const std::lock_guard lock(mutex_);
  advance();
  counts_.framesDropped = screen_.dropped();
  counts_.underruns = screen_.underruns();
  counts_.rotation = screen_.rotation().reading(std::chrono::steady_clock::now());
  return counts_;
}

void IdealDevice::advance() {
  for (IdealScreen::Frame& frame : screen_.advance(std::chrono::steady_clock::now())) {
    if (failure_ || toTake_.size() == kMaxToTake) {
      ++counts_.framesLost;
      counts_.lastProblem = failure_ ? counts_.lastProblem : "frames come faster than they can be written";
      lose(frame, counts_.lastProblem);
      continue;
    }
    ++counts_.framesShown;
    frame.fence->moveTo(frame.state);
    if (frames_ != nullptr) {
      toTake_.push_back({std::move(frame.volume), frame.due});
      changed_.notify_all();
    }
  }
}

void IdealDevice::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    advance();
    if (!toTake_.empty()) {
      Taken next = std::move(toTake_.front());
      lock.unlock();
      std::exception_ptr failure;
      std::string problem;
      try {
        frames_->shown(*next.volume, next.time);
      } catch (const std::exception& error) {
        failure = std::current_exception();
        problem = error.what();
      }
      lock.lock();
      toTake_.pop_front();
      if (failure) {
        failure_ = failure;
        counts_.connected = false;
        counts_.lastProblem = problem;
        toTake_.clear();
      }
      continue;
    }
    if (closing_) {
      return;
    }
    const HostTime next = screen_.nextChange();
    if (next == HostTime::max()) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, next);
    }
  }
}

void IdealDevice::end() {
  if (!thread_.joinable()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    advance();
    closing_ = true;
    for (IdealScreen::Frame& frame : screen_.takeWaiting()) {
      ++counts_.framesLost;
      lose(frame, "the device was closed");
    }
    changed_.notify_all();
  }
  thread_.join();
}

void IdealDevice::close() {
  end();
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  if (frames_ != nullptr) {
    frames_->finish();
  }
}

}  // namespace ocelli
