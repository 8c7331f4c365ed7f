// A trial again in a window, as fast as it was: what the subject saw, frame by frame.
#pragma once

#include "study/replay/trial_replay.h"
#include "study/task/controls.h"

namespace ocelli {

struct ReplayWindowOptions {
  std::string title = "Replay";
  double speed = 1;  ///< times as fast
};

/// Until the trial is over, or the window is closed, or Escape is pressed. Returns whether all of it was shown. Throws
/// GlError where there is no display.
bool showReplay(const TaskBlock& block, const TrialLog& log, const Controls& controls,
                const ReplayWindowOptions& options = {});

}  // namespace ocelli
