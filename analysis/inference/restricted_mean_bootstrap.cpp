#include "analysis/inference/restricted_mean_bootstrap.h"

#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/wald.h"

namespace ocelli {

Estimable<BootstrapResult> bootstrapRestrictedMeanDifference(const std::vector<SurvivalTime>& times,
                                                             const std::vector<bool>& isSecond, double horizon,
                                                             const std::vector<int>& subjects,
                                                             const std::vector<int>& cases, const BootstrapPlan& plan) {
  requireArgument(times.size() == isSecond.size() && times.size() == subjects.size(), "lists differ in length",
                  "bootstrapRestrictedMeanDifference");
  // The data themselves say best why not.
  if (const auto once = restrictedMeanDifference(times, isSecond, horizon); !once) {
    return Estimable<BootstrapResult>::impossible(once.reason());
  }
  const auto statistic = [&](const std::vector<ResampledRow>& rows) -> std::optional<double> {
    std::vector<SurvivalTime> drawnTimes;
    std::vector<bool> drawnGroups;
    drawnTimes.reserve(rows.size());
    drawnGroups.reserve(rows.size());
    for (const ResampledRow& row : rows) {
      drawnTimes.push_back(times[row.row]);
      drawnGroups.push_back(isSecond[row.row]);
    }
    const auto difference = restrictedMeanDifference(drawnTimes, drawnGroups, horizon);
    return difference ? std::optional(difference->difference.value) : std::nullopt;
  };
  return bootstrap(subjects, cases, statistic, plan);
}

}  // namespace ocelli
