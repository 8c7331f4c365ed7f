// Thresholds of subjects, from trials whose stimulus has a level: the measure "level" (above 0), and "guess_rate", the
// share of right answers by guessing, 0.5 where it is missing. Whatever the task is called.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/inference/psychometric.h"
#include "analysis/report/subject_means.h"

namespace ocelli {

bool hasLevels(const TrialList& trials);

struct SubjectThreshold {
  Estimable<PsychometricFit> fit = Estimable<PsychometricFit>::impossible("there are no trials");
  std::vector<LevelCounts> counts{};
};

/// One psychometric function a subject, of one condition.
struct ConditionThresholds {
  std::map<std::string, SubjectThreshold> bySubject{};
  TrialList trials{};  ///< with a level, that say whether the answer was right
  int timeouts = 0;    ///< of these: they count as they are stored, as wrong answers
  double guess = 0.5;  ///< mean over trials
};
/// In the order of the conditions. A subject whose guess rates differ has no threshold.
std::vector<ConditionThresholds> thresholdsOf(const ViewConditions& conditions, const TrialList& trials);

/// Log thresholds of those who have one within the levels that they met: beyond these it is a guess.
SubjectNumbers logThresholds(const ConditionThresholds& thresholds);

}  // namespace ocelli
