// What resampling subjects and cases says of the views, beside the models: it supposes no distribution.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/bootstrap.h"
#include "analysis/report/report_parts.h"

namespace ocelli {

/// As many resamples as the plan says, from its seed.
BootstrapPlan bootstrapPlanOf(const AnalysisPlan& plan);
/// Trial::item() of each, numbered: what models call a case.
std::vector<int> caseNumbers(const TrialList& trials);

/// The sum of `weights` times the means of the groups, of `values` in `groups` (index into weights, -1: in none), one a
/// trial. Resamples in which a group with a weight is empty give nothing.
Estimable<BootstrapResult> bootstrapContrast(const TrialList& trials, const std::vector<double>& values,
                                             const std::vector<int>& groups, const std::vector<double>& weights,
                                             const BootstrapPlan& plan);
/// Mean of other less mean of reference.
Estimable<BootstrapResult> bootstrapViewDifference(const TrialList& trials, const std::vector<double>& values,
                                                   const BootstrapPlan& plan);

/// Likewise of normal values of which the `censored` ones lie above what is given (censored_difference.h).
Estimable<BootstrapResult> bootstrapCensoredViewDifference(const TrialList& trials, const std::vector<double>& values,
                                                           const std::vector<bool>& censored,
                                                           const BootstrapPlan& plan);

struct ResampledEffect {
  std::string label;
  Estimable<BootstrapResult> result;
  TrialList trials;
  std::string unit{};
  bool isLogarithm = false;  ///< shown as a ratio
};
/// A table with percentile and bias-corrected intervals of each.
void addResampled(ReportWork& work, const std::string& caption, const std::string& id,
                  const std::vector<ResampledEffect>& effects);

}  // namespace ocelli
