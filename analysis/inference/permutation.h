// Whether a difference between two conditions could be chance, without supposing any distribution: if there is none,
// the conditions of a subject might as well be named the other way round, which turns the sign of the difference.
//
//   Fisher 1935; Pesarin 2001   the test by all, or many, such turns
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/base/estimable.h"

namespace ocelli {

struct SubjectDifference {
  int subject = 0;
  double difference = 0;
};

struct SignFlipTest {
  double mean = 0;     ///< over subjects, of the mean difference of each
  double pValue = 1;   ///< two-sided; share of turns with a mean at least as far from 0
  bool exact = false;  ///< all turns were tried
  size_t turns = 0;
  size_t subjects = 0;
};

/// All differences of a subject turn together, as what makes them alike is the subject. Up to 2^20 turns are all tried;
/// else as many as `turns` says are drawn, and the data count as one more. Not possible for fewer than 2 subjects or
/// where all differences are 0.
Estimable<SignFlipTest> signFlipTest(const std::vector<SubjectDifference>& differences, uint64_t seed = 1,
                                     size_t turns = 100000);

}  // namespace ocelli
