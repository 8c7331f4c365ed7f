// Which trial comes when: one entry of a session's schedule.
#pragma once

#include <cstdint>
#include <string>

#include "study/trial/trial_words.h"
#include "study/trial/view_condition.h"

namespace ocelli {

struct TrialPlan {
  int index = 0;      ///< in the schedule of the session, from 0; -1 for practice, which is not in the schedule
  int block = 0;      ///< in the protocol, from 0
  std::string task;   ///< its name in study/tasks/task_registry.h
  int caseIndex = 0;  ///< of the block's cases (task.h); of its practice cases in practice
  TrialView view = TrialView::kReference;
  uint64_t seed = 1;  ///< all that is random within the trial comes of it
  bool practice = false;
  ExposureRule exposure = ExposureRule::kClock;

  bool operator==(const TrialPlan&) const = default;
};

}  // namespace ocelli
