// Trials whose answers are numbers (study/trial/estimated_value.h), whatever their task is called, and their errors as
// models take them.
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/report/subject_means.h"
#include "study/trial/estimated_value.h"

namespace ocelli {

/// That which most trials have; nullptr where none holds an estimate.
const EstimateUnit* unitOfEstimates(const TrialList& trials);

/// Trials with an estimate in that unit, and those that have none.
struct EstimateTrials {
  const EstimateUnit* unit = nullptr;
  TrialList trials{};
  std::vector<EstimatedValue> values{};  ///< one a trial
  TrialList missing{};                   ///< timed out, or without an estimate for another reason

  TrialValues signedErrors() const;
  TrialValues absoluteErrors() const;
};
EstimateTrials estimatesIn(const TrialList& trials);

/// What a model of errors is fitted to, one a trial: signed errors, or logarithms of absolute errors. An error of 0 has
/// no logarithm: it counts with half of the smallest error above 0 of these trials, as if the answer had been rounded
/// to the truth.
struct ErrorResponse {
  std::vector<double> values{};
  int zeros = 0;
  double zeroAs = 0;  ///< the absolute error that a zero counts with: of lengths a logarithm of a ratio
};
/// All trials hold an estimate. Impossible where all absolute errors are 0 and their logarithms are asked for.
Estimable<ErrorResponse> errorResponse(const PlannedModel& model, const TrialList& trials);

}  // namespace ocelli
