#include "display_driver/pacing/recording_device.h"

#include <fmt/format.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "display_driver/pacing/device_log_writer.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

/// Volumes that wait to be written.
constexpr size_t kMaxWaiting = 4;
constexpr std::chrono::milliseconds kIdleInterval{20};
constexpr std::chrono::milliseconds kTelemetryInterval{100};

class RecordingDevice final : public Device {
 public:
  RecordingDevice(std::unique_ptr<Device> device, const std::filesystem::path& path,
                  std::function<void(const std::string&)> tell)
      : device_(std::move(device)),
        opened_(Clock::now()),
        tell_(std::move(tell)),
        writer_(path, device_->info(), device_->profile()) {
    thread_ = std::thread([this] { run(); });
  }
  ~RecordingDevice() override { end(); }

  const DeviceInfo& info() const override { return device_->info(); }
  const DisplayProfile& profile() const override { return device_->profile(); }

  void present(FrameNumber frame, const Presentation& presentation) override {
    const std::lock_guard order(order_);
    device_->present(frame, presentation);
    add([this, frame, presentation, time = now()] { writer_.presented(frame, presentation, time); });
  }

  Telemetry telemetry() override {
    Telemetry telemetry = device_->telemetry();
    std::unique_lock lock(mutex_);
    if (!failure_ && Clock::now() - told_ >= kTelemetryInterval) {
      told_ = Clock::now();
      waiting_.push_back([this, telemetry, time = now()] { writer_.told(telemetry, opened_, time); });
      changed_.notify_all();
    }
    if (failure_ && telemetry.lastProblem.empty()) {
      telemetry.lastProblem = "the log is no longer recorded";
    }
    if (failure_ && !std::exchange(breakTold_, true)) {
      lock.unlock();
      tell("the log is no longer recorded: it cannot be written");
    }
    return telemetry;
  }

  void close() override {
    stop();
    std::exception_ptr failure;
    try {
      device_->close();
    } catch (...) {
      failure = std::current_exception();
    }
    finish();
    if (leftOut_ > 0) {
      tell(fmt::format("{} volumes are missing in the device log: they came faster than they could be written",
                       leftOut_));
    }
    if (failure || failure_) {
      std::rethrow_exception(failure ? failure : failure_);
    }
  }

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>> changedSlices) override {
    // Differences refer to the frame before, so frames are written in the order in which the device got them.
    const std::lock_guard order(order_);
    const auto time = now();
    auto fence = changedSlices ? device_->submit(volume, *changedSlices) : device_->submit(volume);
    {
      const std::lock_guard lock(mutex_);
      if (failure_) {
        return fence;
      }
      if (volumes_ == kMaxWaiting) {
        ++leftOut_;
        afterGap_ = true;
        waiting_.push_back([this, fence] { underWay_.push_back(fence); });
        return fence;
      }
      ++volumes_;
    }
    std::optional<std::vector<int>> changed;
    const bool afterGap = std::exchange(afterGap_, false);
    if (changedSlices && !afterGap) {
      changed.emplace(changedSlices->begin(), changedSlices->end());
    }
    add([this, volume, fence, changed = std::move(changed), time] {
      writer_.submitted(fence->number(), *volume,
                        changed ? std::optional<std::span<const int>>(*changed) : std::nullopt, time);
      underWay_.push_back(fence);
      const std::lock_guard lock(mutex_);
      --volumes_;
    });
    return fence;
  }

 private:
  void tell(const std::string& what) const {
    if (tell_) {
      tell_(what);
    }
  }

  DeviceLogWriter::Time now() const {
    return std::chrono::duration_cast<DeviceLogWriter::Time>(Clock::now() - opened_);
  }

  void add(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    if (!failure_) {
      waiting_.push_back(std::move(work));
      changed_.notify_all();
    }
  }

  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      while (!waiting_.empty() && !failure_) {
        const std::function<void()> work = std::move(waiting_.front());
        waiting_.pop_front();
        attempt(lock, work);
        changed_.notify_all();
      }
      if (stopping_ || failure_) {
        return;
      }
      attempt(lock, [this] { writeEnds(); });
      if (waiting_.empty() && !stopping_) {
        changed_.wait_for(lock, kIdleInterval);
      }
    }
  }

  /// Without the mutex meanwhile.
  void attempt(std::unique_lock<std::mutex>& lock, const std::function<void()>& work) {
    lock.unlock();
    std::exception_ptr failure;
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) {
      failure_ = failure;
      waiting_.clear();
      changed_.notify_all();
    }
  }

  void writeEnds() {
    std::erase_if(underWay_, [this](const std::shared_ptr<const FrameFence>& fence) {
      const FrameState state = fence->state();
      if (hasEnded(state.stage)) {
        writer_.ended(fence->number(), state, opened_, now());
      }
      return hasEnded(state.stage);
    });
  }

  /// All that has passed is written; nothing more is added.
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
      changed_.notify_all();
    }
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  /// After the thread, and after the device, which has ended every frame.
  void finish() {
    if (failure_) {
      return;
    }
    try {
      writeEnds();
      writer_.finish(now());
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

  void end() {
    stop();
    device_ = nullptr;
  }

  std::unique_ptr<Device> device_;
  const HostTime opened_;
  const std::function<void(const std::string&)> tell_;
  DeviceLogWriter writer_;                                   ///< of the thread, and after it
  std::vector<std::shared_ptr<const FrameFence>> underWay_;  ///< likewise

  std::mutex order_;       ///< over submissions and what follows, up to the other one
  bool afterGap_ = false;  ///< the volume before is not in the log
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  size_t volumes_ = 0;  ///< of those that wait, and the one that is being written
  uint64_t leftOut_ = 0;
  bool breakTold_ = false;
  HostTime told_{};
  std::exception_ptr failure_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<Device> recordDeviceLog(std::unique_ptr<Device> device, const std::filesystem::path& path,
                                        std::function<void(const std::string&)> tell) {
  return std::make_unique<RecordingDevice>(std::move(device), path, std::move(tell));
}

}  // namespace ocelli
