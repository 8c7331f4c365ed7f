#include "study/replay/trial_replay.h"

#include <fmt/format.h>

namespace ocelli {
namespace {

/// A trial that was completed ends by itself: without an outcome after so many ticks of nothing it never will.
constexpr int64_t kMaxTicks = 3600 * kTicksPerSecond;

class Replay {
 public:
  Replay(const TaskBlock& block, const TrialLog& log, const ReplayOptions& options)
      : log_(log), options_(options), run_(block.start(log.record.plan, log.record.screen)) {}

  ReplayVerdict run() {
    const bool completed = log_.record.ending == TrialEnding::kCompleted;
    size_t input = 0;
    size_t frame = 0;
    // What came at a tick takes effect before the frame that shows it; then the tick passes.
    for (int64_t tick = 0; tick < kMaxTicks; ++tick) {
      for (; input < log_.inputs.size() && log_.inputs[input].tick <= tick; ++input) {
        run_->handle(log_.inputs[input].event);
      }
      for (; frame < log_.frames.size() && log_.frames[frame].tick <= tick; ++frame) {
        show(log_.frames[frame]);
      }
      const bool logged = input < log_.inputs.size() || frame < log_.frames.size();
      if (!logged && (!completed || run_->outcome())) {
        break;
      }
      run_->advance();
    }
    compareOutcome(completed);
    return std::move(verdict_);
  }

 private:
  void note(std::string difference) {
    if (verdict_.firstDifference.empty()) {
      verdict_.firstDifference = std::move(difference);
    }
  }

  void show(const FrameRecord& frame) {
    ++verdict_.frames;
    const WalkerPose pose = run_->pose();
    if (pose == frame.pose) {
      ++verdict_.samePoses;
    } else {
      note(fmt::format("frame {} at tick {}: the log has ({}, {}, {} rad), the replay ({}, {}, {} rad)", frame.frame,
                       frame.tick, frame.pose.x, frame.pose.z, frame.pose.headingRadians, pose.x, pose.z,
                       pose.headingRadians));
    }
    if (frame.pixelHash && options_.views) {
      ++verdict_.hashes;
      const uint64_t hash = pixelHashOf(options_.views(run_->layout(), log_.record.screen));
      if (hash == *frame.pixelHash) {
        ++verdict_.sameHashes;
      } else {
        note(fmt::format("frame {}: the pixels have hash {:016x}, not {:016x}", frame.frame, hash, *frame.pixelHash));
      }
    }
    if (options_.onFrame) {
      options_.onFrame(frame, *run_);
    }
    run_->frameShown(ticksBetween(log_.frames.front().shownNanoseconds, frame.shownNanoseconds));
  }

  void compareOutcome(bool completed) {
    const std::optional<TrialOutcome> outcome = run_->outcome();
    if (!completed) {
      verdict_.sameOutcome = !outcome;
      if (outcome) {
        note("the trial was stopped, but the replay comes to an end: \"" + outcome->answer + "\"");
      }
      return;
    }
    const TrialOutcome& stored = log_.record.outcome;
    verdict_.sameOutcome = outcome && *outcome == stored;
    if (!outcome) {
      note("the replay comes to no end");
    } else if (!verdict_.sameOutcome) {
      note(fmt::format("the outcome: the log has \"{}\" at tick {}, the replay \"{}\" at tick {}, or other measures",
                       stored.answer, stored.responseTicks, outcome->answer, outcome->responseTicks));
    }
  }

  const TrialLog& log_;
  const ReplayOptions& options_;
  std::unique_ptr<TrialRun> run_;
  ReplayVerdict verdict_{};
};

}  // namespace

ReplayVerdict replayTrial(const TaskBlock& block, const TrialLog& log, const ReplayOptions& options) {
  return Replay(block, log, options).run();
}

}  // namespace ocelli
