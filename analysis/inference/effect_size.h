// How large an effect is, in units that compare across studies.
//
//   Cohen 1988; Lakens 2013                  d_z and d_av of pairs, d of groups
//   Hedges 1981                              the correction for few values, exact
//   Steiger and Fouladi 1997                 intervals of d from the noncentral t distribution
//   Cliff 1993; Feng and Cliff 2004          delta of groups, with its interval
//   Kerby 2014                               matched-pairs rank-biserial correlation
//   Newcombe 1998, method 10                 interval of the difference of two shares
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/binomial_test.h"

namespace ocelli {

struct PairedEffect {
  Estimate dz;  ///< mean of the differences over their standard deviation
  /// The same mean over the mean standard deviation of the two conditions. DEVIATION: its interval is that of dz in
  /// these units, which leaves out that the standard deviations are estimates.
  Estimate dav;
  Estimate correctedDz;  ///< Hedges' g; kNotKnown for 2 pairs, as the next
  Estimate correctedDav;
  size_t pairs = 0;
};

/// Of second - first, one pair a subject. Not possible for fewer than 2 pairs, or where a spread is 0. Throws
/// InputError for lists of different lengths.
Estimable<PairedEffect> pairedEffect(const std::vector<double>& first, const std::vector<double>& second,
                                     double level = 0.95);

struct GroupEffect {
  Estimate d;           ///< difference of means over the pooled standard deviation
  Estimate correctedD;  ///< Hedges' g
  size_t first = 0;
  size_t second = 0;
};

/// Of second - first. Not possible for fewer than 2 values in a group, or without spread.
Estimable<GroupEffect> groupEffect(const std::vector<double>& first, const std::vector<double>& second,
                                   double level = 0.95);

/// Of successes in the second group to the first; intervals on the log scale. Not possible where an outcome never came
/// in a group that the ratio divides by or takes the logarithm of.
Estimable<Estimate> oddsRatio(const Share& first, const Share& second, double level = 0.95);
Estimable<Estimate> riskRatio(const Share& first, const Share& second, double level = 0.95);
/// Not possible where a group has no trials only.
Estimable<Estimate> riskDifference(const Share& first, const Share& second, double level = 0.95);

/// P(second > first) - P(second < first), of independent groups. Bounds are kNotKnown where it is -1 or 1. Not possible
/// for fewer than 2 values in a group.
Estimable<Estimate> cliffsDelta(const std::vector<double>& first, const std::vector<double>& second,
                                double level = 0.95);

/// Of differences: share of the ranks in favour less the share against. The interval is Fisher's, approximate; bounds
/// are kNotKnown where it is -1 or 1. Not possible where all are 0.
Estimable<Estimate> matchedRankBiserial(const std::vector<double>& differences, double level = 0.95);

}  // namespace ocelli
