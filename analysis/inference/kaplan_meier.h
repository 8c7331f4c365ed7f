// Which share of the trials has not ended yet, as a function of time, where some were cut off.
//
//   Kaplan and Meier 1958      the curve
//   Greenwood 1926             its standard errors, trials taken as independent
//   Efron 1982, section 6      the infinitesimal jackknife, whose values are summed by cluster: standard errors where
//                              trials of a subject are alike, and trials of a case (crossed_clusters.h)
//   Kalbfleisch, Prentice 1980 intervals on the scale log(-log S)
//   Brookmeyer, Crowley 1982   the interval of the median: where the interval of the curve crosses a half
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

/// The curve from this time to the next.
struct SurvivalStep {
  RiskSet riskSet;
  double survival = 1;
  double standardError = 0;  ///< of `survival`; kNotKnown where that is 0, or where clusters do not give one
  double lower = kNotKnown;  ///< kNotKnown where `survival` is 0 or 1, or without a standard error
  double upper = kNotKnown;
};

struct SurvivalCurve {
  std::vector<SurvivalStep> steps;  ///< one for each different time, ascending
  size_t trials = 0;
  size_t events = 0;
  std::string noBands;  ///< why there are no standard errors at any time: a whole clause; empty where there are
};

/// Without clusters the trials are taken as independent and the interval is normal. With clusters, such as a subject
/// for each trial, and `items`, clusters that cross these such as cases, the error is that of crossed_clusters.h and
/// the interval is Student's with its degrees of freedom. Of one cluster alone, or one item, the curve has no bands.
/// Not possible without trials. Throws InputError for invalid times, and lists of different lengths.
Estimable<SurvivalCurve> survivalCurve(const std::vector<SurvivalTime>& times, double level = 0.95,
                                       const std::vector<int>& clusters = {}, const std::vector<int>& items = {});

/// The time at which the curve falls to a half; where it stays there for a while, the middle of that. A bound that the
/// data do not reach is infinite above and kNotKnown below; without bands both are kNotKnown. Not possible where the
/// curve never falls so far.
Estimable<Estimate> medianTime(const SurvivalCurve& curve);

}  // namespace ocelli
