// The mean time until the earlier of an event and the horizon: the area under the Kaplan-Meier curve. Unlike a
// mean of the observed times it does not pretend that trials without an event never were, or took just as long as they
// were watched.
//
//   Irwin 1949; Royston and Parmar 2013   the restricted mean, and its difference between groups
//   Klein and Moeschberger 2003, (4.5.2)  the standard error, from Greenwood's
//   Efron 1982, section 6                 the infinitesimal jackknife, whose values are summed by cluster
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/survival_data.h"

namespace ocelli {

struct RestrictedMean {
  Estimate mean;  ///< seconds
  size_t trials = 0;
  size_t events = 0;    ///< before the horizon
  size_t clusters = 0;  ///< 0: none were given
};

/// `horizon` in seconds. Without clusters the trials are taken as independent and the interval is normal. With
/// clusters, one for each trial, the standard error is that of the infinitesimal jackknife by cluster, times the root
/// of clusters / (clusters - 1), and the interval is Student's with clusters - 1 degrees of freedom. `items`: clusters
/// that cross these, as crossed_clusters.h has them. The p value is kNotKnown. Not possible where no trial has an event
/// before the horizon, where all have it at one moment, where the curve ends before the horizon, or for a single
/// cluster. Throws InputError for invalid input.
Estimable<RestrictedMean> restrictedMean(const std::vector<SurvivalTime>& times, double horizon,
                                         const std::vector<int>& clusters = {}, double level = 0.95,
                                         const std::vector<int>& items = {});

struct RestrictedMeanDifference {
  RestrictedMean first, second;
  Estimate difference;  ///< second - first, seconds; its p value is of "it is 0"
};

/// Of the trials whose `isSecond` is true from the others. Clusters may have trials in both groups, as subjects have
/// who see both views: what they share cancels out in the difference.
Estimable<RestrictedMeanDifference> restrictedMeanDifference(const std::vector<SurvivalTime>& times,
                                                             const std::vector<bool>& isSecond, double horizon,
                                                             const std::vector<int>& clusters = {}, double level = 0.95,
                                                             const std::vector<int>& items = {});

}  // namespace ocelli
