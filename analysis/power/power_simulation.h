// Simulates studies of several sizes by a protocol, with the data-only subject, and analyses each by a plan.
#pragma once

#include <vector>

#include "analysis/power/power_effects.h"
#include "analysis/report/power_study.h"
#include "oc_core/base/progress.h"
#include "oc_core/ranks/ranks.h"

namespace ocelli {

struct PowerWork {
  const Protocol& protocol;
  const AnalysisPlan& plan;
  const PlannedModel& model;                   ///< of the plan, as viewModelOf() gives it, or that of the contrast
  const PlannedEquivalence* bounds = nullptr;  ///< of the plan, where equivalence is tested too
  std::vector<int> subjects{};                 ///< rising
  int simulations = 1;                         ///< studies of each number of subjects and truth
  double alpha = 0.05;
  double dropOut = 0;  ///< share of subjects who do not come back after each session
  uint64_t seed = 1;
  const PlannedContrast* contrast = nullptr;  ///< of the model, that is tested in place of its term "view"
};

/// How many sessions each subject of a study takes part in.
std::vector<int> sessionsOf(const Protocol& protocol, int subjects, double dropOut, uint64_t seed);

/// A curve for each test of each truth, in their order. The same for any number of threads, and each number of subjects
/// as if it were the only one. Throws InputError where the plan is not for the protocol.
std::vector<PowerCurve> simulatePower(const PowerWork& work, const std::vector<Truth>& truths,
                                      const Progress& progress = {});
/// The same by ranks together, each of which simulates some of the studies: rank 0 has the curves, the others nothing.
std::vector<PowerCurve> simulatePower(const PowerWork& work, const std::vector<Truth>& truths, Ranks& ranks,
                                      const Progress& progress = {});

}  // namespace ocelli
