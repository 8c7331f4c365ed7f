#include "analysis/report/search_times.h"

#include <algorithm>

#include "analysis/report/planned_model.h"
#include "analysis/report/resampled_effects.h"

namespace ocelli {
namespace {

constexpr double kUsualLimit = 60;  // s, section 7.4.2

}  // namespace

bool isCensored(const Trial* trial) {
  return trial->censored.value_or(false);
}

const char* labelOf(TimeoutTreatment timeouts) {
  return timeouts == TimeoutTreatment::kSetToLimit ? "set to the limit" : nameOf(timeouts);
}

TrialList withoutTimeouts(TrialList trials) {
  std::erase_if(trials, isCensored);
  return trials;
}

double searchLimit(const TrialList& trials) {
  double limit = 0;
  for (const Trial* trial : trials) {
    limit = std::max(limit, trial->longestSeconds.value_or(0));
  }
  return limit > 0 ? limit : kUsualLimit;
}

std::vector<bool> areOther(const TrialList& trials) {
  std::vector<bool> isOther;
  for (const Trial* trial : trials) {
    isOther.push_back(trial->view == TrialView::kOther);
  }
  return isOther;
}

std::vector<SurvivalTime> timesOf(const TrialList& trials, TimeoutTreatment timeouts) {
  std::vector<SurvivalTime> times;
  for (const Trial* trial : trials) {
    times.push_back({*trial->responseSeconds, timeouts == TimeoutTreatment::kSetToLimit || !isCensored(trial)});
  }
  return times;
}

bool namesCases(const PlannedModel& model) {
  return std::any_of(model.randomEffects.begin(), model.randomEffects.end(),
                     [](const RandomEffect& effect) { return effect.group == "case"; });
}

SurvivalData survivalDataOf(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts) {
  SurvivalData data{timesOf(trials, timeouts), covariatesOf(model, trials), {}, numbered(subjectsOf(trials))};
  if (namesCases(model)) {
    data.items = caseNumbers(trials);
  }
  data.fewClusters = true;
  return data;
}

Estimable<RestrictedMeanDifference> restrictedMeanDifferenceOf(const TrialList& trials, TimeoutTreatment timeouts,
                                                               double limit) {
  return restrictedMeanDifference(timesOf(trials, timeouts), areOther(trials), limit, numbered(subjectsOf(trials)),
                                  0.95, caseNumbers(trials));
}

}  // namespace ocelli
