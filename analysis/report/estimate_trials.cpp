#include "analysis/report/estimate_trials.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "oc_core/base/check.h"

namespace ocelli {

const EstimateUnit* unitOfEstimates(const TrialList& trials) {
  std::map<const EstimateUnit*, int> counts;
  for (const Trial* trial : trials) {
    if (const std::optional<EstimatedValue> value = estimatedValue(trial->measures)) {
      ++counts[value->unit];
    }
  }
  const EstimateUnit* most = nullptr;
  for (const EstimateUnit& unit : estimateUnits()) {
    if (counts[&unit] > (most == nullptr ? 0 : counts[most])) {
      most = &unit;
    }
  }
  return most;
}

EstimateTrials estimatesIn(const TrialList& trials) {
  EstimateTrials result;
  result.unit = unitOfEstimates(trials);
  for (const Trial* trial : trials) {
    const std::optional<EstimatedValue> value = estimatedValue(trial->measures);
    if (value && value->unit == result.unit) {
      result.trials.push_back(trial);
      result.values.push_back(*value);
    } else {
      result.missing.push_back(trial);
    }
  }
  return result;
}

TrialValues EstimateTrials::signedErrors() const {
  TrialValues errors;
  for (size_t i = 0; i < trials.size(); ++i) {
    errors.push_back({trials[i], values[i].signedError()});
  }
  return errors;
}

TrialValues EstimateTrials::absoluteErrors() const {
  TrialValues errors = signedErrors();
  for (TrialValue& error : errors) {
    error.value = std::abs(error.value);
  }
  return errors;
}

Estimable<ErrorResponse> errorResponse(const PlannedModel& model, const TrialList& trials) {
  ErrorResponse response;
  const EstimateTrials estimates = estimatesIn(trials);
  OC_CHECK(estimates.missing.empty(), "each trial of a model of errors holds an estimate in the same unit");
  for (const EstimatedValue& value : estimates.values) {
    response.values.push_back(value.signedError());
  }
  if (model.kind != ModelKind::kAbsoluteErrorMixed) {
    return response;
  }
  double smallest = INFINITY;
  for (double& error : response.values) {
    error = std::abs(error);
    response.zeros += error == 0 ? 1 : 0;
    smallest = error > 0 ? std::min(smallest, error) : smallest;
  }
  if (std::isinf(smallest)) {
    return Estimable<ErrorResponse>::impossible(trials.empty() ? "no trial holds an estimate"
                                                               : "all estimates are exact");
  }
  response.zeroAs = smallest / 2;
  for (double& error : response.values) {
    error = std::log(error > 0 ? error : response.zeroAs);
  }
  return response;
}

}  // namespace ocelli
