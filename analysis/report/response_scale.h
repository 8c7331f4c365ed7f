// How what a mixed model says is shown: a row for each kind of response. A model itself works with log seconds, logits,
// signed errors, or logarithms of absolute errors.
#pragma once

#include <string>

#include "analysis/report/report_parts.h"
#include "study/trial/estimated_value.h"

namespace ocelli {

struct ResponseScale {
  enum class Means : uint8_t { kExponential, kProbability, kPlain };

  const char* one;          ///< an effect: "ratio of times"
  const char* several;      ///< "ratios of times"
  const char* axis;         ///< "Ratio of times"
  const char* lowerSide;    ///< what effects below none mean: "faster"
  const char* upperSide;    ///< "slower"
  const char* meanName;     ///< of a condition: "geometric mean time"
  const char* meanUnit;     ///< "s"
  const char* fittedLabel;  ///< "Fitted log seconds"
  Means means = Means::kExponential;
  bool isRatio = true;  ///< effects are shown exponentiated; else they are differences in `effectUnit`
  const char* effectUnit = "";
};

/// `unit`: of the estimates, for models of signed errors; nullptr elsewhere.
const ResponseScale& responseScale(const PlannedModel& model, const EstimateUnit* unit);
/// With the unit of the trials' own estimates.
const ResponseScale& responseScale(const PlannedModel& model, const TrialList& trials);

Estimate shownEffect(const ResponseScale& scale, const Estimate& effect);
Estimate shownMean(const ResponseScale& scale, const Estimate& mean);

}  // namespace ocelli
