// Records of trials as rows of the table `trial` (study/trial/trial_row.h), and back.
#pragma once

#include <string>

#include "study/session/records.h"
#include "study/trial/trial_row.h"

namespace ocelli {

/// A trial that begins; `number` among those of its run. Its file gives it `trialId` and `runId`.
TrialRow rowOf(const RunRecord& run, int number, const TrialPlan& plan, int attempt, const std::string& block);

/// Adds what is known of a trial that has ended.
void addEnd(TrialRow& row, const TrialRecord& record);

/// Of a trial that has not ended, only the plan and the attempt are known.
TrialRecord recordOf(const TrialRow& row);

}  // namespace ocelli
