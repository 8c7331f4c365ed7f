// A display on a slow link, in a time that only goes on where somebody waits or works.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "display_driver/device/ideal_screen.h"
#include "display_driver/pacing/pace_clock.h"
#include "display_driver/pacing/volume_source.h"

namespace ocelli::test {

inline std::chrono::nanoseconds milliseconds(double count) {
  return std::chrono::nanoseconds(std::llround(count * 1e6));
}

class VirtualClock final : public PaceClock {
 public:
  HostTime now() override { return now_; }
  void waitUntil(HostTime time) override { now_ = std::max(now_, time); }
  void work(std::chrono::nanoseconds time) { now_ += time; }

 private:
  HostTime now_{std::chrono::seconds(100)};
};

struct VirtualDisplayOptions {
  /// Of a frame's transfer; those that come in the meantime wait, the newest wins.
  std::function<double(FrameNumber)> linkMilliseconds = [](FrameNumber) { return 5.0; };
  double rotationsPerMinute = 720;  ///< in truth
  bool tellsRotation = true;
};

class VirtualDisplay final : public Device {
 public:
  VirtualDisplay(VirtualClock& clock, VirtualDisplayOptions options)
      : clock_(clock), options_(std::move(options)), profile_(loadProfile("test")) {
    restart();
  }

  const DeviceInfo& info() const override { return info_; }
  const DisplayProfile& profile() const override { return profile_; }

  void present(FrameNumber frame, const Presentation& presentation) override {
    advance();
    for (auto* under : {&sending_, &waiting_}) {
      if (*under && (*under)->frame.fence->number() == frame) {
        (*under)->frame.presentation = presentation;
      }
    }
    screen_->present(frame, presentation, clock_.now());
  }

  Telemetry telemetry() override {
    advance();
    Telemetry telemetry;
    telemetry.connected = connected_;
    if (options_.tellsRotation && connected_) {
      telemetry.rotation = screen_->rotation().reading(clock_.now());
    }
    return telemetry;
  }
  void close() override {}

  /// The rotation begins anew; frames that wait are lost.
  void restart() {
    DisplayProfile real = profile_;
    real.rotationsPerMinute = options_.rotationsPerMinute;
    if (screen_ != nullptr) {
      loseAll();
    }
    screen_ = std::make_unique<IdealScreen>(real, clock_.now());
  }
  void setConnected(bool connected) {
    advance();
    connected_ = connected;
    if (!connected) {
      loseAll();
    }
  }

  /// That were shown, in their order.
  std::vector<FrameNumber> shown;
  RotationPhase lastShownAt;

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume>,
                                                std::optional<std::span<const int>>) override {
    advance();
    auto fence = std::make_shared<FrameFence>(++lastNumber_);
    IdealScreen::Frame frame{.fence = fence, .volume = nullptr, .state = {}, .presentation = {}};
    if (!connected_) {
      end(frame, FrameStage::kLost);
    } else if (!sending_) {
      send(std::move(frame), clock_.now());
    } else {
      if (waiting_) {
        end(waiting_->frame, FrameStage::kDropped);
      }
      waiting_ = Sending{std::move(frame), {}};
    }
    return fence;
  }

 private:
  struct Sending {
    IdealScreen::Frame frame;
    HostTime done;
  };
  void send(IdealScreen::Frame frame, HostTime begin) {
    const FrameNumber number = frame.fence->number();
    sending_ = Sending{std::move(frame), begin + milliseconds(options_.linkMilliseconds(number))};
  }
  static void end(IdealScreen::Frame& frame, FrameStage stage) {
    frame.state.stage = stage;
    frame.fence->moveTo(frame.state);
  }
  void loseAll() {
    for (auto* under : {&sending_, &waiting_}) {
      if (*under) {
        end((*under)->frame, FrameStage::kLost);
        under->reset();
      }
    }
    for (IdealScreen::Frame& frame : screen_->takeWaiting()) {
      end(frame, FrameStage::kLost);
    }
  }
  void show(HostTime now) {
    for (IdealScreen::Frame& frame : screen_->advance(now)) {
      shown.push_back(frame.fence->number());
      lastShownAt = {frame.state.shownRefresh, frame.state.shownSlice};
      frame.fence->moveTo(frame.state);
    }
  }
  void advance() {
    while (sending_ && sending_->done <= clock_.now()) {
      Sending done = std::move(*sending_);
      sending_.reset();
      show(done.done);
      const FrameNumber number = done.frame.fence->number();
      const auto presentation = done.frame.presentation;
      screen_->add(std::move(done.frame), done.done);
      if (presentation) {
        screen_->present(number, *presentation, done.done);
      }
      if (waiting_) {
        send(std::move(std::exchange(waiting_, std::nullopt)->frame), done.done);
      }
    }
    show(clock_.now());
  }

  VirtualClock& clock_;
  VirtualDisplayOptions options_;
  DisplayProfile profile_;
  DeviceInfo info_{.kind = "virtual", .name = "virtual", .serial = {}, .link = {}};
  std::unique_ptr<IdealScreen> screen_;
  std::optional<Sending> sending_;
  std::optional<Sending> waiting_;
  bool connected_ = true;
  FrameNumber lastNumber_ = 0;
};

/// Takes so long for the volume with this number, counted from 0.
class VirtualSource final : public VolumeSource {
 public:
  VirtualSource(VirtualClock& clock, std::function<double(int)> milliseconds)
      : clock_(clock),
        milliseconds_(std::move(milliseconds)),
        volume_(std::make_shared<const Volume>(loadProfile("test"))) {}

  /// Makes volumes in two stages from now on: this one, and that which was given first.
  void overlap(std::function<double(int)> secondMilliseconds) {
    line_ = std::make_unique<Line>(*this, std::move(secondMilliseconds));
  }
  VolumeLine* line() override { return line_.get(); }

  SourcedVolume volumeFor(HostTime time) override {
    if (asked == ends) {
      return {};
    }
    const int number = asked++;
    if (same && same(number)) {
      return {.kind = SourcedVolume::Kind::kSame};
    }
    seen.push_back(time);
    clock_.work(milliseconds(milliseconds_(number)));
    if (after) {
      after(number);
    }
    return {.kind = SourcedVolume::Kind::kNew, .volume = volume_};
  }

  /// As if each stage had a processor of its own.
  class Line final : public VolumeLine {
   public:
    Line(VirtualSource& source, std::function<double(int)> second) : source_(source), second_(std::move(second)) {}
    bool ready() const override { return source_.clock_.now() >= firstFree_ && underWay_.size() < 2; }
    void begin(HostTime seen) override {
      const HostTime now = source_.clock_.now();
      if (source_.asked == source_.ends) {
        underWay_.push_back({now, {}});
        return;
      }
      const int number = source_.asked++;
      if (source_.same && source_.same(number)) {
        underWay_.push_back({now, {.kind = SourcedVolume::Kind::kSame}});
        return;
      }
      source_.seen.push_back(seen);
      firstFree_ = now + milliseconds(source_.milliseconds_(number));
      secondFree_ = std::max(firstFree_, secondFree_) + milliseconds(second_(number));
      underWay_.push_back({secondFree_, {.kind = SourcedVolume::Kind::kNew, .volume = source_.volume_}});
      if (source_.after) {
        source_.after(number);
      }
    }
    std::optional<SourcedVolume> finished() override {
      if (underWay_.empty() || underWay_.front().first > source_.clock_.now()) {
        return std::nullopt;
      }
      const SourcedVolume volume = underWay_.front().second;
      underWay_.pop_front();
      return volume;
    }

   private:
    VirtualSource& source_;
    std::function<double(int)> second_;
    HostTime firstFree_{};
    HostTime secondFree_{};
    std::deque<std::pair<HostTime, SourcedVolume>> underWay_;
  };

  std::vector<HostTime> seen;
  std::function<bool(int)> same;
  std::function<void(int)> after;
  int asked = 0;
  int ends = -1;

 private:
  VirtualClock& clock_;
  std::function<double(int)> milliseconds_;
  std::shared_ptr<const Volume> volume_;
  std::unique_ptr<Line> line_;
};

}  // namespace ocelli::test
