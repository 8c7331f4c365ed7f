// A share of successes, with intervals, against a chance that is known beforehand, such as 1/3 of guessing among three
// paths.
//
//   Clopper and Pearson 1934   the interval that never covers too rarely
//   Wilson 1927                the score interval, which covers about as often as it says
#pragma once

#include <cstddef>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

/// Successes among trials.
struct Share {
  int successes = 0;
  int trials = 0;
};

/// The share with its interval; no statistic and no p value. There is at least one trial.
Estimate wilsonShare(const Share& share, double level = 0.95);
Estimate clopperPearsonShare(const Share& share, double level = 0.95);

struct BinomialTest {
  Share share;
  double chance = 0;
  Estimate clopperPearson;  ///< its p value is exact: of all outcomes that are no more likely than this one
  Estimate wilson;          ///< its z and p value are of the score test
  double pAbove = 1;        ///< exact and one-sided, of "no more often than by chance"
};

/// It takes trials as independent. Not possible without trials. Throws InputError for invalid counts, and a
/// chance that is not between 0 and 1.
Estimable<BinomialTest> binomialTest(const Share& share, double chance, double level = 0.95);

}  // namespace ocelli
