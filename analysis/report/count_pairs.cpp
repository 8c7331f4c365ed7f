#include "analysis/report/count_pairs.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "analysis/inference/crossed_clusters.h"
#include "analysis/inference/sample.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/resampled_effects.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

/// The key that scenes of one kind share, for all subjects.
std::string kindOf(const Trial& trial) {
  return fmt::format("{}/{}/{}/{}/{}", trial.session, trial.block, trial.exposureSeconds.value_or(-1),
                     trial.objects.value_or(-1), trial.duplicateColors.value_or(false));
}

}  // namespace

std::vector<PairedOutcome> matchedScenes(const TrialList& trials) {
  std::map<std::string, int> seen;
  std::vector<PairedOutcome> outcomes;
  for (const Trial* trial : trials) {
    const std::string scene = fmt::format("{}/{}", trial->subject, kindOf(*trial));
    const int number = seen[fmt::format("{}/{}", scene, markOf(trial->view))]++;
    outcomes.push_back(
        {fmt::format("{}/{}", scene, number), trial->view == TrialView::kOther, trial->correct.value_or(false)});
  }
  return outcomes;
}

Estimable<Estimate> matchedDifference(const TrialList& trials) {
  const std::vector<PairedOutcome> outcomes = matchedScenes(trials);
  struct Pair {
    std::array<const Trial*, 2> trials{};
  };
  std::map<std::string, Pair> pairs;
  for (size_t i = 0; i < outcomes.size(); ++i) {
    pairs[outcomes[i].pair].trials[outcomes[i].isSecond] = trials[i];
  }
  std::vector<double> differences;
  std::vector<std::string> subjects;
  std::vector<std::string> kinds;
  for (const auto& [name, pair] : pairs) {
    if (pair.trials[0] != nullptr && pair.trials[1] != nullptr) {
      differences.push_back(pair.trials[1]->correct.value_or(false) - pair.trials[0]->correct.value_or(false));
      subjects.push_back(pair.trials[0]->subject);
      kinds.push_back(kindOf(*pair.trials[0]));
    }
  }
  return clusteredMean(differences, crossedClusters(numbered(subjects), numbered(kinds)));
}

std::optional<double> signedError(const Trial& trial) {
  const std::optional<double> answer = numberFromText<double>(trial.answer);
  const std::optional<double> expected = numberFromText<double>(trial.expected);
  return answer && expected ? std::optional<double>(*answer - *expected) : std::nullopt;
}

std::vector<double> errorDifferences(const TrialList& trials) {
  struct Errors {
    double sum = 0;
    int count = 0;
  };
  std::map<std::string, std::array<Errors, 2>> bySubject;
  for (const Trial* trial : trials) {
    if (const std::optional<double> error = signedError(*trial)) {
      Errors& errors = bySubject[trial->subject][trial->view == TrialView::kOther];
      errors.sum += *error;
      ++errors.count;
    }
  }
  std::vector<double> differences;
  for (const auto& [subject, views] : bySubject) {
    if (views[0].count > 0 && views[1].count > 0) {
      differences.push_back(differenceOf(views[0].sum / views[0].count, views[1].sum / views[1].count));
    }
  }
  return differences;
}

Estimable<Estimate> errorDifference(const TrialList& trials) {
  std::vector<double> errors;
  std::vector<bool> isOther;
  TrialList answered;
  for (const Trial* trial : trials) {
    if (const std::optional<double> error = signedError(*trial)) {
      errors.push_back(*error);
      isOther.push_back(trial->view == TrialView::kOther);
      answered.push_back(trial);
    }
  }
  return clusteredMeanDifference(errors, isOther, numbered(subjectsOf(answered)), caseNumbers(answered));
}

}  // namespace ocelli
