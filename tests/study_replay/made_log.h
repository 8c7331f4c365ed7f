// Logs of trials that random hands did.
#pragma once

#include "study/replay/trial_replay.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli::test {

inline constexpr int64_t kHashedFrames = 4;

/// Nanoseconds at which a frame of these logs is shown.
inline int64_t shownAt(int64_t tick) {
  return tick * 1'000'000'000 / kTicksPerSecond;
}

/// Of a trial of the example with input that makes little sense, until it is over or `ticks` have passed, and then
/// stopped.
inline TrialLog madeLog(const TaskBlock& block, const TaskExample& example, uint64_t seed, int64_t ticks = 1 << 20) {
  TrialLog log;
  log.record.plan = planOf(example.task, 0, seed % 2 == 0 ? TrialView::kReference : TrialView::kOther, seed);
  log.record.info = block.caseInfo(0);
  log.record.screen = {120, 75, 60};
  const auto run = block.start(log.record.plan, log.record.screen);
  Random random(seed);
  for (int64_t tick = 0; !run->outcome() && tick < ticks; ++tick) {
    for (size_t i = random.below(4) == 0 ? 1 : 0; i > 0; --i) {
      const InputEvent event = randomInput(random, log.record.screen);
      run->handle(event);
      log.inputs.push_back({shownAt(tick), tick, event});
    }
    if (tick % 4 == 0 && !run->outcome()) {
      FrameRecord frame;
      frame.frame = static_cast<int64_t>(log.frames.size());
      frame.tick = tick;
      frame.shownNanoseconds = shownAt(tick);
      frame.pose = run->pose();
      if (frame.frame < kHashedFrames) {
        frame.pixelHash = pixelHashOf(viewsOf(run->layout(), log.record.screen, rasterizeStudy));
      }
      log.frames.push_back(frame);
      run->frameShown(ticksBetween(0, shownAt(tick)));
    }
    run->advance();
  }
  log.record.ending = run->outcome() ? TrialEnding::kCompleted : TrialEnding::kAborted;
  log.record.outcome = run->outcome().value_or(TrialOutcome{});
  return log;
}

}  // namespace ocelli::test
