// Measures of trials whose stimulus has a level, which a staircase chose: what a task writes (study/task/task.h,
// TrialOutcome::measures) and an analysis of thresholds reads, whatever the task is called.
#pragma once

namespace ocelli {

inline constexpr const char* kLevelMeasure = "level";           ///< above 0; its logarithm is the stimulus
inline constexpr const char* kGuessRateMeasure = "guess_rate";  ///< share of right answers by guessing
inline constexpr double kUsualGuessRate = 0.5;                  ///< where a trial has no guess rate

}  // namespace ocelli
