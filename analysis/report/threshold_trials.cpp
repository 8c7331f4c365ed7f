#include "analysis/report/threshold_trials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/report/right_answers.h"
#include "study/trial/level_measures.h"

namespace ocelli {
namespace {

std::optional<double> levelOf(const Trial& trial) {
  const auto found = trial.measures.find(kLevelMeasure);
  return found != trial.measures.end() && std::isfinite(found->second) && found->second > 0
             ? std::optional(found->second)
             : std::nullopt;
}

double guessRateOf(const Trial& trial) {
  const auto found = trial.measures.find(kGuessRateMeasure);
  return found == trial.measures.end() ? kUsualGuessRate : found->second;
}

SubjectThreshold thresholdOf(const TrialList& trials) {
  using Fit = Estimable<PsychometricFit>;
  std::vector<double> levels;
  std::vector<bool> right;
  PsychometricModel model;
  model.guess = guessRateOf(*trials.front());
  bool differ = false;
  for (const Trial* trial : trials) {
    levels.push_back(*levelOf(*trial));
    right.push_back(trial->correct.value_or(false));
    differ = differ || guessRateOf(*trial) != model.guess;
  }
  SubjectThreshold result;
  result.counts = levelCounts(levels, right);
  const bool canBe = model.guess >= 0 && model.guess < 1 - kMaxLapse;
  result.fit = differ   ? Fit::impossible("its trials have several guess rates")
               : !canBe ? Fit::impossible("its guess rate is none from 0 to below 0.9")
                        : fitPsychometric(model, result.counts);
  return result;
}

}  // namespace

bool hasLevels(const TrialList& trials) {
  return std::any_of(trials.begin(), trials.end(), [](const Trial* trial) { return levelOf(*trial).has_value(); });
}

std::vector<ConditionThresholds> thresholdsOf(const ViewConditions& conditions, const TrialList& trials) {
  std::vector<ConditionThresholds> result(conditions.size());
  for (const TrialView view : conditions.all()) {
    ConditionThresholds& condition = result[indexOfCondition(view)];
    std::map<std::string, TrialList> bySubject;
    double guesses = 0;
    for (const Trial* trial : answeredTrials(trialsOfView(trials, view))) {
      if (levelOf(*trial)) {
        condition.trials.push_back(trial);
        condition.timeouts += trial->censored.value_or(false) ? 1 : 0;
        guesses += guessRateOf(*trial);
        bySubject[trial->subject].push_back(trial);
      }
    }
    if (!condition.trials.empty()) {
      condition.guess = guesses / static_cast<double>(condition.trials.size());
    }
    for (const auto& [subject, ofSubject] : bySubject) {
      condition.bySubject[subject] = thresholdOf(ofSubject);
    }
  }
  return result;
}

SubjectNumbers logThresholds(const ConditionThresholds& thresholds) {
  SubjectNumbers numbers;
  for (const auto& [subject, threshold] : thresholds.bySubject) {
    if (threshold.fit && !threshold.fit->outside) {
      numbers.bySubject[subject] = threshold.fit->point.logThreshold;
    }
  }
  std::copy_if(thresholds.trials.begin(), thresholds.trials.end(), std::back_inserter(numbers.trials),
               [&](const Trial* trial) { return numbers.bySubject.contains(trial->subject); });
  return numbers;
}

}  // namespace ocelli
