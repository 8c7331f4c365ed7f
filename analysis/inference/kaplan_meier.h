// Which share of the trials has not ended yet, as a function of time, where some were cut off.
//
//   Kaplan and Meier 1958      the curve
//   Greenwood 1926             its standard errors
//   Kalbfleisch, Prentice 1980 intervals on the scale log(-log S)
//   Brookmeyer, Crowley 1982   the interval of the median: where the interval of the curve crosses a half
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

/// The curve from this time to the next.
struct SurvivalStep {
  RiskSet riskSet;
  double survival = 1;
  double standardError = 0;  ///< of `survival`; kNotKnown where it is 0
  double lower = kNotKnown;  ///< kNotKnown where `survival` is 0 or 1
  double upper = kNotKnown;
};

struct SurvivalCurve {
  std::vector<SurvivalStep> steps;  ///< one for each different time, ascending
  size_t trials = 0;
  size_t events = 0;
};

/// Not possible without trials. Throws AnalysisError for times that are none.
Estimable<SurvivalCurve> survivalCurve(const std::vector<SurvivalTime>& times, double level = 0.95);

/// The time at which the curve falls to a half; where it stays there for a while, the middle of that. A bound that the
/// data do not reach is infinite above and kNotKnown below. Not possible where the curve never falls so far.
Estimable<Estimate> medianTime(const SurvivalCurve& curve);

}  // namespace ocelli
