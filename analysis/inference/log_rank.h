// Whether times to an event differ between groups: observed events against those expected if they did not.
//
//   Mantel 1966; Peto and Peto 1972   the test, with the hypergeometric variance
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

struct LogRankGroup {
  int label = 0;
  size_t trials = 0;
  double observed = 0;
  double expected = 0;  ///< events
};

struct LogRankTest {
  std::vector<LogRankGroup> groups;  ///< by label
  Estimate chiSquared;               ///< with groups - 1 degrees of freedom
};

/// `groups` and `strata` have a label a trial; without strata all trials are compared with each other. It takes trials
/// as independent: several of one subject make its p value too small or, where subjects are in all groups, too large.
/// Not possible for one group or without events. Throws InputError for lists of different lengths.
Estimable<LogRankTest> logRankTest(const std::vector<SurvivalTime>& times, const std::vector<int>& groups,
                                   const std::vector<int>& strata = {});

}  // namespace ocelli
