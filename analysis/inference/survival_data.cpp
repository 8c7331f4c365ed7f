#include "analysis/inference/survival_data.h"

#include <algorithm>
#include <cmath>

#include "analysis/inference/wald.h"

namespace ocelli {

std::vector<RiskSet> riskSets(const std::vector<SurvivalTime>& times) {
  std::vector<SurvivalTime> sorted = times;
  std::sort(sorted.begin(), sorted.end(),
            [](const SurvivalTime& a, const SurvivalTime& b) { return a.seconds < b.seconds; });
  std::vector<RiskSet> sets;
  for (size_t i = 0; i < sorted.size(); ++i) {
    if (sets.empty() || sets.back().seconds < sorted[i].seconds) {
      sets.push_back({sorted[i].seconds, sorted.size() - i, 0, 0});
    }
    ++(sorted[i].observed ? sets.back().events : sets.back().censored);
  }
  return sets;
}

void checkTimes(const std::vector<SurvivalTime>& times, const char* function) {
  const bool sound = std::all_of(times.begin(), times.end(), [](const SurvivalTime& time) {
    return std::isfinite(time.seconds) && time.seconds >= 0;
  });
  requireArgument(sound, "a time is negative or not finite", function);
}

void checkSurvivalData(const SurvivalData& data, const char* function) {
  checkTimes(data.times, function);
  const size_t trials = data.times.size();
  checkCovariates(data.covariates, trials, function);
  requireArgument(data.strata.empty() || data.strata.size() == trials, "strata and trials differ in number", function);
  requireArgument(data.clusters.empty() || data.clusters.size() == trials, "clusters and trials differ in number",
                  function);
  requireArgument(data.items.empty() || (data.items.size() == trials && !data.clusters.empty()),
                  "items and clusters of trials differ in number", function);
}

}  // namespace ocelli
