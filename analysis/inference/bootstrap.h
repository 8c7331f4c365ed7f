// How far a statistic would vary if other subjects had come, and other cases had been shown: it is computed again for
// subjects, and crossed with them cases, drawn from those that there are.
//
//   Efron and Tibshirani 1993, chapter 14   percentile and BCa intervals
//   Owen 2007, "The pigeonhole bootstrap"   subjects and cases drawn at once: a trial counts as often as its subject
//                                           was drawn,
//                                           times its case. The spread comes out somewhat too wide, by up to twice what
//                                           the trials vary by themselves, and never too narrow in the mean
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

/// A trial that was drawn. Who is drawn twice is two subjects then, each with a number of its own.
struct ResampledRow {
  size_t row = 0;
  int subject = 0;
  int caseIndex = 0;
};

/// Nothing: it cannot be estimated from these rows. It is called by several threads at once.
using BootstrapStatistic = std::function<std::optional<double>(const std::vector<ResampledRow>&)>;

enum class ResampledUnits { kSubjects, kSubjectsAndCases };

struct BootstrapPlan {
  uint64_t seed = 1;
  size_t resamples = 2000;
  ResampledUnits units = ResampledUnits::kSubjectsAndCases;
  double level = 0.95;
};

struct BootstrapResult {
  Estimate percentile;      ///< the statistic of the data, the standard deviation of the resamples, their quantiles
  Estimable<Estimate> bca;  ///< the same with the interval corrected for bias and skewness
  double notEstimable = 0;  ///< share of the resamples that gave nothing and are left out
  size_t resamples = 0;     ///< with these
  size_t subjects = 0;
  size_t cases = 0;  ///< 0: cases were not drawn
};

/// `subjects` and `cases` have a label a row; cases may be empty where they are not drawn. The numbers depend on the
/// plan alone, not on how many threads there are. Not possible where the data do not give the statistic, with one
/// subject or case, where more than half of the resamples give nothing, or where all give the same. Throws
/// InputError for lists of different lengths, and fewer than 100 resamples.
Estimable<BootstrapResult> bootstrap(const std::vector<int>& subjects, const std::vector<int>& cases,
                                     const BootstrapStatistic& statistic, const BootstrapPlan& plan);

/// The BCa interval (Efron and Tibshirani, (14.9) to (14.15)) from the resampled values. `influences` are the
/// shares of the independent units in the deviation of the statistic, whose skewness is the acceleration. Not possible
/// where all values lie on one side of the estimate.
Estimable<Estimate> bcaInterval(std::vector<double> values, double estimate, const std::vector<double>& influences,
                                double level);

}  // namespace ocelli
