// Searches whose times depend on subjects and cases, and what is fitted to them.
#pragma once

#include <functional>

#include "analysis/inference/accelerated_failure_time.h"
#include "analysis/inference/cox.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli::test {

using Fit = std::function<Estimable<Estimate>(const SurvivalData&)>;

/// Of the first covariate, on the scale of logarithms.
Estimable<Estimate> coxTerm(const SurvivalData& data);
Estimable<Estimate> logNormalTerm(const SurvivalData& data);

/// Standard deviations in log seconds.
struct Spread {
  double ofSubjects = 0.25, ofSubjectViews = 0.15, ofCases = 0.35, ofCaseViews = 0, ofTrials = 0.45;
};

/// Searches without an effect of the view, up to 60 s; each subject has each case in both views. Cases with an odd
/// number move.
SurvivalData searches(int subjects, int cases, const Spread& spread, RandomNumbers& random);

}  // namespace ocelli::test
