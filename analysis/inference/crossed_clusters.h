// Variances of what trials contribute to an estimate, where trials of a subject are alike, and so are trials of a case,
// of all subjects.
//
//   Cameron, Gelbach and Miller 2011, J. Bus. Econ. Stat. 29(2), section 2   clusters that cross each other
//
// DEVIATION: what the second clusters add, their variance less that of the trials that share both, counts where it is
// positive only: the sum is then never less than the variance by the first ones alone.
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/wald.h"

namespace ocelli {

struct CrossedClusters {
  DenseLabels first;   ///< such as subjects
  DenseLabels second;  ///< such as cases; none: there are no others
  DenseLabels both;    ///< trials that share both

  /// The fewer clusters, less 1.
  double degreesOfFreedom() const;
};
/// `second`: one a trial as `first`, or none.
CrossedClusters crossedClusters(const std::vector<int>& first, const std::vector<int>& second);

/// clusters / (clusters - coefficients): values are less what was estimated from them, at least a mean.
double fewClustersFactor(const DenseLabels& clusters, size_t coefficients = 1);

/// Of the sum of the values, each of a trial, whose expectation is 0. `coefficients`: that may differ between the
/// second clusters, such as the means of two views of which a case has one.
double clusteredVariance(const std::vector<double>& values, const CrossedClusters& clusters, size_t coefficients = 1);

/// With Student's t. Not possible where a kind of clusters has one member, or where nothing varies.
Estimable<Estimate> clusteredEstimate(double value, const std::vector<double>& contributions,
                                      const CrossedClusters& clusters, double level = 0.95, size_t coefficients = 1);

/// The mean of values, one a trial.
Estimable<Estimate> clusteredMean(const std::vector<double>& values, const CrossedClusters& clusters,
                                  double level = 0.95);

/// The mean over the first clusters that have trials of both kinds of what their mean in the second kind exceeds that
/// in the first. Not possible where none has both.
Estimable<Estimate> clusteredMeanDifference(const std::vector<double>& values, const std::vector<bool>& isSecond,
                                            const std::vector<int>& first, const std::vector<int>& second,
                                            double level = 0.95);

}  // namespace ocelli
