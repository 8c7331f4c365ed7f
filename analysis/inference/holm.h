// p values that stand beside each other, adjusted so that the chance of even one false finding in a family stays at the
// level.
//
//   Holm 1979
#pragma once

#include <string>
#include <vector>

namespace ocelli {

/// In the same order. A test that could not be done (kNotKnown) stays so and counts as the largest p value: a family
/// has the size that was planned, or else the data would decide how strict the others' correction is. Throws
/// InputError for numbers that are no p values.
std::vector<double> holmAdjusted(const std::vector<double>& pValues);

struct FamilyTest {
  std::string family;
  double pValue = 1;
};

/// Each family for itself.
std::vector<double> holmAdjusted(const std::vector<FamilyTest>& tests);

}  // namespace ocelli
