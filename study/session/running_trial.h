// A trial that runs: tells it at which tick what happens, and hands its log to the sink.
#pragma once

#include <memory>
#include <vector>

#include "study/session/session_flow.h"

namespace ocelli {

class RunningTrial {
 public:
  /// `sink` must outlive it. `number` is that of the trial among those that this run began.
  RunningTrial(std::unique_ptr<TrialRun> run, int number, SessionSink& sink)
      : run_(std::move(run)), number_(number), sink_(sink) {}

  const TrialRun& run() const { return *run_; }
  bool isOver() const { return run_->outcome().has_value(); }
  int number() const { return number_; }

  /// Time has come to `now`: ticks pass until then, or until the trial is over.
  void update(int64_t now);
  /// The same until the input takes effect, and then it does. False, and nothing is done with the input, where its tick
  /// is yet to come, and where the trial is over before it.
  bool take(const TimedInput& input, int64_t now);
  void frameShown(int64_t nanoseconds, std::optional<uint64_t> pixelHash);
  /// Keeps those that came since the first frame.
  void takeGaze(std::span<const GazeRecord> samples);
  /// Of the next frame.
  int64_t nextFrame() const { return static_cast<int64_t>(shown_.size()); }
  /// When each frame was shown; the first of them began the trial.
  const std::vector<int64_t>& shownNanoseconds() const { return shown_; }

  /// Hands the log so far to the sink.
  void handOver();

 private:
  int64_t tickAt(int64_t nanoseconds) const;
  void advanceTo(int64_t tick);

  std::unique_ptr<TrialRun> run_;
  int number_;
  SessionSink& sink_;
  int64_t tick_ = 0;
  int64_t lastShownTick_ = -1;  ///< of the last frame
  std::vector<int64_t> shown_{};
  std::vector<FrameRecord> frames_{};  ///< not handed over yet
  std::vector<InputRecord> inputs_{};
  std::vector<GazeRecord> gaze_{};
  int64_t handedOver_ = 0;  ///< when
};

}  // namespace ocelli
