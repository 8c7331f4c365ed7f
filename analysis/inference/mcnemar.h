// Successes in pairs of trials: the same subject, the same scene, one view and the other. Pairs with the same outcome
// in both say nothing about a difference.
//
//   McNemar 1947                              the test
//   Fagerland, Lydersen and Laake 2013        exact and mid-p forms; the mid-p one is recommended
//   Bonett and Price 2012                     interval of the difference: Wald's, with a pair more of each unlike kind
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

struct PairedOutcome {
  std::string pair;  ///< the same for the two trials of a pair
  bool isSecond = false;
  bool success = false;
};

struct PairedCounts {
  int both = 0;
  int onlyFirst = 0;
  int onlySecond = 0;
  int neither = 0;
  int unpaired = 0;  ///< trials whose partner is missing; they count nowhere else

  int pairs() const { return both + onlyFirst + onlySecond + neither; }
};

/// Throws InputError where a pair has two trials of the same condition.
PairedCounts pairOutcomes(const std::vector<PairedOutcome>& outcomes);

struct McNemarTest {
  PairedCounts counts;
  Estimate difference;            ///< of the shares of successes, second - first; no p value
  Estimable<Estimate> oddsRatio;  ///< of success in the second to the first; interval and p value exact
  double exactP = 1;              ///< two-sided, as the rest
  double midP = 1;
  Estimate chiSquared;
  Estimate chiSquaredCorrected;  ///< with Edwards' correction for continuity
};

/// It takes pairs as independent. Not possible where no pair differs. The ratio is not possible where all that differ
/// do so in one direction: it would be 0 or infinite.
Estimable<McNemarTest> mcNemarTest(const PairedCounts& counts, double level = 0.95);

}  // namespace ocelli
