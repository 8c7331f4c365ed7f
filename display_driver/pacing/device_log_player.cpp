#include "display_driver/pacing/device_log_player.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "display_driver/pacing/rotation_clock.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kStopCheckInterval{5};
/// For a frame to be shown, or to end.
constexpr std::chrono::seconds kMaxWait{2};

class Player {
 public:
  Player(DeviceLogReader& reader, Device& device, PaceClock& clock, const DeviceLogPlayerOptions& options,
         const std::function<bool()>& stop)
      : reader_(reader),
        device_(device),
        clock_(clock),
        options_(options),
        stop_(stop),
        recorded_(1 / reader.profile().refreshHertz()),
        rotation_(1 / device.profile().refreshHertz()) {}

  DeviceLogPlayed play() {
    const HostTime begin = clock_.now();
    while (const auto record = reader_.next()) {
      const HostTime due = begin + std::chrono::microseconds(record->microseconds);
      if (!options_.fast) {
        waitUntil(due);
      }
      if (stopped()) {
        break;
      }
      std::visit([&](const auto& what) { take(what, HostTime(std::chrono::microseconds(record->microseconds))); },
                 record->what);
    }
    const HostTime end = clock_.now();
    played_.seconds = std::chrono::duration<double>(end - begin).count();
    while (!ended() && clock_.now() - end < kMaxWait && !stopped()) {
      clock_.waitUntil(clock_.now() + kStopCheckInterval);
      look();
    }
    played_.ending = reader_.ending();
    return played_;
  }

 private:
  bool stopped() const { return stop_ && stop_(); }

  void look() {
    const Telemetry telemetry = device_.telemetry();
    if (telemetry.rotation) {
      rotation_.add(*telemetry.rotation);
    }
    played_.countEnded();
    std::erase_if(presented_, [](const auto& fence) { return hasEnded(fence->state().stage); });
  }

  void waitUntil(HostTime time) {
    look();
    while (clock_.now() < time && !stopped()) {
      clock_.waitUntil(std::min(time, clock_.now() + kStopCheckInterval));
      look();
    }
  }

  /// Those that wait without a time stay until the device is closed.
  bool ended() const { return presented_.empty(); }

  void take(const DeviceLogRecord::Submitted& submitted, HostTime) {
    const auto fence =
        played_.submitted == 0 ? device_.submit(submitted.volume) : device_.submit(submitted.volume, submitted.changed);
    ++played_.submitted;
    numbers_[submitted.frame] = fence;
    if (numbers_.size() > kMaxNumbers) {
      numbers_.erase(numbers_.begin());
    }
    played_.underWay.push_back(fence);
  }

  void take(const DeviceLogRecord::Presented& presented, HostTime then) {
    const auto fence = numbers_.find(presented.frame);
    if (fence == numbers_.end()) {
      return;
    }
    Presentation presentation = presented.presentation;
    if (presentation.at) {
      presentation.at = carriedOver(*presentation.at, then);
    }
    device_.present(fence->second->number(), presentation);
    presented_.insert(fence->second);
    ++played_.presented;
    if (options_.fast) {
      const HostTime begin = clock_.now();
      while (!hasEnded(fence->second->state().stage) && clock_.now() - begin < kMaxWait && !stopped()) {
        clock_.waitUntil(clock_.now() + 1ms);
        look();
      }
    }
  }

  void take(const DeviceLogRecord::Ended&, HostTime) {}
  void take(const Telemetry& telemetry, HostTime) {
    if (telemetry.rotation) {
      recorded_.add(*telemetry.rotation);
    }
  }

  std::optional<RotationPhase> carriedOver(const RotationPhase& at, HostTime then) {
    if (options_.fast || !recorded_.running() || !rotation_.running()) {
      return std::nullopt;
    }
    const double ahead = static_cast<double>(at.refresh) - recorded_.refreshesAt(then);
    const double refresh = std::round(rotation_.refreshesAt(clock_.now()) + ahead);
    // Further ahead than any display counts.
    return RotationPhase{static_cast<uint64_t>(std::clamp(refresh, 0.0, 1e15)), at.slice};
  }

  /// Frames that may still be presented.
  static constexpr size_t kMaxNumbers = 64;

  DeviceLogReader& reader_;
  Device& device_;
  PaceClock& clock_;
  DeviceLogPlayerOptions options_;
  const std::function<bool()>& stop_;
  RotationClock recorded_;
  RotationClock rotation_;
  std::map<FrameNumber, std::shared_ptr<const FrameFence>> numbers_;  ///< by their numbers in the log
  std::set<std::shared_ptr<const FrameFence>> presented_;             ///< that have not ended
  DeviceLogPlayed played_;
};

}  // namespace

void DeviceLogPlayed::countEnded() {
  std::erase_if(underWay, [this](const std::shared_ptr<const FrameFence>& fence) {
    const FrameStage stage = fence->state().stage;
    shown += stage == FrameStage::kShown ? 1 : 0;
    dropped += stage == FrameStage::kDropped ? 1 : 0;
    lost += stage == FrameStage::kLost ? 1 : 0;
    return hasEnded(stage);
  });
}

DeviceLogPlayed playDeviceLog(DeviceLogReader& reader, Device& device, PaceClock& clock,
                              const DeviceLogPlayerOptions& options, const std::function<bool()>& stop) {
  OC_CHECK(reader.profile() == device.profile(), "a log is played on another display");
  return Player(reader, device, clock, options, stop).play();
}

}  // namespace ocelli
