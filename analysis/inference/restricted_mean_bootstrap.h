// The difference of restricted means with the interval that counts subjects and cases as drawn from more of their kind.
#pragma once

#include <vector>

#include "analysis/inference/bootstrap.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

/// Seconds; second - first, as restrictedMeanDifference(). Resamples in which a group has no event, or ends before the
/// horizon, give nothing. Not possible where bootstrap() is not.
Estimable<BootstrapResult> bootstrapRestrictedMeanDifference(const std::vector<SurvivalTime>& times,
                                                             const std::vector<bool>& isSecond, double horizon,
                                                             const std::vector<int>& subjects,
                                                             const std::vector<int>& cases, const BootstrapPlan& plan);

}  // namespace ocelli
