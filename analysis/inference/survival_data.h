// Times to an event, some of which are only known to be longer: time ran out.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/inference/covariate.h"

namespace ocelli {

struct SurvivalTime {
  double seconds = 0;
  bool observed = true;  ///< false: censored; it would have come after `seconds`
};

/// How the times of a group stand at one moment. A time that is censored there counts as at risk there.
struct RiskSet {
  double seconds = 0;
  size_t atRisk = 0;
  size_t events = 0;
  size_t censored = 0;
};

/// At each different time, in ascending order.
std::vector<RiskSet> riskSets(const std::vector<SurvivalTime>& times);

/// What a regression of times is given. All lists have one entry a trial, or none where a comment says so.
struct SurvivalData {
  std::vector<SurvivalTime> times;
  std::vector<Covariate> covariates;
  std::vector<int> strata;    ///< whose base hazards differ; none: a single stratum
  std::vector<int> clusters;  ///< such as subjects, for robust errors; none: every trial stands for itself
  std::vector<int>
      items{};  ///< such as cases, clusters that cross these (crossed_clusters.h); none: there are no others
  /// Robust errors and intervals for few clusters: those of cluster_jackknife.h, and Student's t with its
  /// degrees of freedom. Else as R's survival: a sandwich, and z.
  bool fewClusters = false;
};

/// Throws InputError where lists differ in length, or a number is not finite or a time negative.
void checkTimes(const std::vector<SurvivalTime>& times, const char* function);
void checkSurvivalData(const SurvivalData& data, const char* function);

}  // namespace ocelli
