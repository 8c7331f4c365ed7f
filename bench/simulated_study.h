// Studies whose effects are known, in the shape of a protocol: its schedule, cases and sessions, with subjects who drop
// out. For how often intervals hold the truth, and how often a true null is rejected.
//
//   times      log(seconds) = average + effects + subject + subject's view + item + item's view + trial, stopped at a
//                             limit
//   hazards    rate = exp(average + effects + item + item's view) * frailty of the subject, stopped at a limit
//   answers    logit(right) = average + effects + subject + subject's view + item + item's view; wrong counts are one
//                             off
//
// Effects are multiplied with columns about their means over the trials; view, moving and duplicates are -0.5 and 0.5
// before that. Items are the cases of a block in a session, the same for all subjects (Trial::item()).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/tables/table_cells.h"
#include "oc_core/base/random_numbers.h"
#include "study/protocol/protocol.h"

namespace ocelli {

enum class SimulatedOutcome { kTimes, kHazards, kAnswers };

struct SimulatedTruth {
  SimulatedOutcome outcome = SimulatedOutcome::kTimes;
  double average = 0;
  std::map<std::string, double> effects{};  ///< by term: "view", "session", "view:session"
  // Standard deviations.
  double ofSubjects = 0;
  double ofSubjectViews = 0;
  double ofItems = 0;
  double ofItemViews = 0;  ///< of the effect of the view on an item; half of it counts for either view
  double ofTrials = 0;
  double ofErrors = 0;         ///< of the logit by item that a wrong count is too many
  double frailty = 1;          ///< of hazards: index of a positive stable variable; 1 for none
  double limitSeconds = 1e12;  ///< of times and hazards
};

/// The trials of a task that a protocol's schedule gives, without answers. `sessions`: of each subject.
std::vector<Trial> plannedTrials(const Protocol& protocol, const std::string& task, const std::vector<int>& sessions);

/// 25 subjects with three sessions, and 20 with one (section 7.4.1).
std::vector<int> sessionsOf2010();

class SimulatedStudy {
 public:
  SimulatedStudy(std::vector<Trial> planned, SimulatedTruth truth);

  const SimulatedTruth& truth() const { return truth_; }
  const std::vector<Trial>& planned() const { return trials_; }
  std::vector<Trial> draw(RandomNumbers& numbers) const;

  // Over all subjects and items that might be.
  std::vector<double> probabilities() const;  ///< of right answers, one a trial
  double shareDifference() const;  ///< mean over the subjects of their share right in the graph camera less the pinhole
  double limitedMeanDifference() const;  ///< of times, in seconds up to the limit: the graph camera less the pinhole

 private:
  std::vector<Trial> trials_;
  SimulatedTruth truth_;
  std::vector<size_t> subjects_{};  ///< of each trial
  std::vector<size_t> items_{};
  size_t subjectCount_ = 0;
  size_t itemCount_ = 0;
  std::vector<double> predictor_{};  ///< of each trial, without what is random
};

/// Pointers to the trials, which must stay.
TrialList listOf(const std::vector<Trial>& trials);

}  // namespace ocelli
