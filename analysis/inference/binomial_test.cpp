#include "analysis/inference/binomial_test.h"

#include <algorithm>
#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Outcomes of the same likelihood differ by rounding only.
constexpr double kSameLikelihood = 1 + 1e-7;

double exactTwoSided(const Share& share, double chance) {
  const double most = binomialDensity(share.successes, share.trials, chance) * kSameLikelihood;
  double sum = 0;
  for (int k = 0; k <= share.trials; ++k) {
    const double density = binomialDensity(k, share.trials, chance);
    sum += density <= most ? density : 0;
  }
  return std::min(sum, 1.0);
}

}  // namespace

Estimate wilsonShare(const Share& share, double level) {
  const double z = normalQuantile((1 + level) / 2);
  const double n = share.trials;
  const double p = share.successes / n;
  const double center = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double width = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  Estimate estimate;
  estimate.value = p;
  estimate.lower = share.successes == 0 ? 0 : center - width;
  estimate.upper = share.successes == share.trials ? 1 : center + width;
  return estimate;
}

Estimate clopperPearsonShare(const Share& share, double level) {
  const double tail = (1 - level) / 2;
  const double successes = share.successes;
  const double failures = share.trials - share.successes;
  Estimate estimate;
  estimate.value = successes / share.trials;
  estimate.lower = successes == 0 ? 0 : betaQuantile(tail, successes, failures + 1);
  estimate.upper = failures == 0 ? 1 : betaQuantile(1 - tail, successes + 1, failures);
  return estimate;
}

Estimable<BinomialTest> binomialTest(const Share& share, double chance, double level) {
  requireArgument(share.successes >= 0 && share.successes <= share.trials, "more successes than trials",
                  "binomialTest");
  requireArgument(chance > 0 && chance < 1, "the chance is not between 0 and 1", "binomialTest");
  if (share.trials == 0) {
    return Estimable<BinomialTest>::impossible("there are no trials");
  }
  BinomialTest test;
  test.share = share;
  test.chance = chance;
  test.clopperPearson = clopperPearsonShare(share, level);
  test.clopperPearson.pValue = exactTwoSided(share, chance);
  test.wilson = wilsonShare(share, level);
  test.wilson.statistic = (test.wilson.value - chance) / std::sqrt(chance * (1 - chance) / share.trials);
  test.wilson.degreesOfFreedom = kInfinite;
  test.wilson.pValue = twoSidedNormal(test.wilson.statistic);
  // As failures, so that small values keep their digits.
  test.pAbove = binomialProbability(share.trials - share.successes, share.trials, 1 - chance);
  return test;
}

}  // namespace ocelli
