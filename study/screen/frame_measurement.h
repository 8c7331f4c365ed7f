// When frames come to the screen, measured before a subject sits there: of a plain page, and of the trials themselves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/window/gl_window.h"
#include "study/outline/subject_texts.h"
#include "study/protocol/schedule.h"
#include "study/session/records.h"

namespace ocelli {

/// Of a clock that never jumps, nanoseconds.
int64_t steadyNow();

/// Shows a plain page for so many seconds, and returns when each frame was shown. On the main thread.
std::vector<int64_t> measureFrames(GlWindow& window, double seconds, const SubjectTexts& texts);

/// One block in one condition.
struct MeasuredTrial {
  std::string block;
  std::string condition;
  TrialTiming timing{};
};

/// Shows the first image of a trial of each block and condition of the schedule, each for half a second and at least 12
/// frames, and judges the frames as those of trials. On the main thread, which must not hold the window's context.
std::vector<MeasuredTrial> measureTrials(GlWindow& window, const Protocol& protocol, const SessionSchedule& schedule,
                                         const TrialScreen& screen, int64_t intervalNanoseconds);

/// A sentence for each that is too slow for the screen; none where all keep up.
std::vector<std::string> slowTrials(const std::vector<MeasuredTrial>& measured);

}  // namespace ocelli
