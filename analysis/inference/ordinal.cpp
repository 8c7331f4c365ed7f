#include "analysis/inference/ordinal.h"

#include <algorithm>

#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"

namespace ocelli {

Estimable<OrdinalDistribution> ordinalDistribution(const std::vector<int>& answers, int steps, double level) {
  requireArgument(steps >= 2, "the scale has fewer than two steps", "ordinalDistribution");
  requireArgument(
      std::all_of(answers.begin(), answers.end(), [&](int answer) { return answer >= 1 && answer <= steps; }),
      "an answer is not on the scale", "ordinalDistribution");
  if (answers.empty()) {
    return Estimable<OrdinalDistribution>::impossible("there are no answers");
  }
  OrdinalDistribution distribution;
  distribution.answers = static_cast<int>(answers.size());
  distribution.counts.resize(static_cast<size_t>(steps));
  for (const int answer : answers) {
    ++distribution.counts[static_cast<size_t>(answer - 1)];
    ++(2 * answer < steps + 1    ? distribution.belowMiddle
       : 2 * answer == steps + 1 ? distribution.atMiddle
                                 : distribution.aboveMiddle);
  }
  for (const int count : distribution.counts) {
    distribution.shares.push_back(wilsonShare({count, distribution.answers}, level));
  }
  std::vector<double> sorted(answers.begin(), answers.end());
  std::sort(sorted.begin(), sorted.end());
  distribution.mean = momentsOf(sorted).mean;
  distribution.median = medianOfSorted(sorted);
  return distribution;
}

Estimable<MiddleTest> testAgainstMiddle(const std::vector<int>& answers, int steps, double level) {
  const Estimable<OrdinalDistribution> distribution = ordinalDistribution(answers, steps, level);
  if (!distribution) {
    return Estimable<MiddleTest>::impossible(distribution.reason());
  }
  const int aside = distribution->belowMiddle + distribution->aboveMiddle;
  if (aside == 0) {
    return Estimable<MiddleTest>::impossible("all answers are at the middle");
  }
  std::vector<double> fromMiddle;
  for (const int answer : answers) {
    fromMiddle.push_back(answer - (steps + 1) / 2.0);
  }
  return MiddleTest{*binomialTest({distribution->aboveMiddle, aside}, 0.5, level), *signedRankTest(fromMiddle, level)};
}

}  // namespace ocelli
