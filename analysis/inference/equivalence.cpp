#include "analysis/inference/equivalence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/student.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

void check(const EquivalenceBounds& bounds, double alpha, const char* function) {
  requireArgument(bounds.lower < bounds.upper, "the lower bound is not below the upper one", function);
  requireArgument(alpha > 0 && alpha < 0.5, "alpha is not between 0 and 0.5", function);
}

}  // namespace

EquivalenceTest equivalenceOf(double difference, double standardError, double degreesOfFreedom,
                              const EquivalenceBounds& bounds, double alpha) {
  check(bounds, alpha, "equivalenceOf");
  EquivalenceTest test;
  test.bounds = bounds;
  test.alpha = alpha;
  test.difference = waldEstimate(difference, standardError, 1 - 2 * alpha, degreesOfFreedom);
  test.pAboveLower = studentProbability(-(difference - bounds.lower) / standardError, degreesOfFreedom);
  test.pBelowUpper = studentProbability((difference - bounds.upper) / standardError, degreesOfFreedom);
  test.pValue = std::max(test.pAboveLower, test.pBelowUpper);
  test.equivalent = test.pValue < alpha;
  return test;
}

Estimable<EquivalenceTest> equivalenceOfPairedMeans(const std::vector<double>& differences,
                                                    const EquivalenceBounds& bounds, double alpha) {
  check(bounds, alpha, "equivalenceOfPairedMeans");
  requireFinite(differences, "equivalenceOfPairedMeans");
  if (differences.size() < 2) {
    return Estimable<EquivalenceTest>::impossible(
        fmt::format("there are {} differences, and 2 are needed", differences.size()));
  }
  const SampleMoments moments = momentsOf(differences);
  if (moments.variance == 0) {
    return Estimable<EquivalenceTest>::impossible("all differences are the same");
  }
  EquivalenceTest test =
      equivalenceOf(moments.mean, std::sqrt(moments.variance / moments.count), moments.count - 1, bounds, alpha);
  test.first = test.second = differences.size();
  return test;
}

Estimable<EquivalenceTest> equivalenceOfMeans(const std::vector<double>& first, const std::vector<double>& second,
                                              const EquivalenceBounds& bounds, double alpha) {
  check(bounds, alpha, "equivalenceOfMeans");
  const Estimable<Estimate> difference = welchDifference(first, second);
  if (!difference) {
    return Estimable<EquivalenceTest>::impossible(difference.reason());
  }
  EquivalenceTest test =
      equivalenceOf(difference->value, difference->standardError, difference->degreesOfFreedom, bounds, alpha);
  test.first = first.size();
  test.second = second.size();
  return test;
}

Estimable<EquivalenceTest> equivalenceOfShares(const Share& first, const Share& second, const EquivalenceBounds& bounds,
                                               double alpha) {
  check(bounds, alpha, "equivalenceOfShares");
  if (first.trials == 0 || second.trials == 0) {
    return Estimable<EquivalenceTest>::impossible("a group has no trials");
  }
  const double p = static_cast<double>(first.successes) / first.trials;
  const double q = static_cast<double>(second.successes) / second.trials;
  const double variance = p * (1 - p) / first.trials + q * (1 - q) / second.trials;
  if (!(variance > 0)) {
    return Estimable<EquivalenceTest>::impossible("in each group all trials have the same outcome");
  }
  EquivalenceTest test = equivalenceOf(q - p, std::sqrt(variance), kInfinite, bounds, alpha);
  test.first = static_cast<size_t>(first.trials);
  test.second = static_cast<size_t>(second.trials);
  return test;
}

Estimable<EquivalenceTest> equivalenceOfPairedShares(const PairedCounts& counts, const EquivalenceBounds& bounds,
                                                     double alpha) {
  check(bounds, alpha, "equivalenceOfPairedShares");
  const double pairs = counts.pairs();
  const double difference = counts.onlySecond - counts.onlyFirst;
  const double variance = counts.onlySecond + counts.onlyFirst - difference * difference / pairs;
  if (!(variance > 0)) {
    return Estimable<EquivalenceTest>::impossible(
        fmt::format("all of {} pairs differ in the same way, or none does", counts.pairs()));
  }
  EquivalenceTest test = equivalenceOf(difference / pairs, std::sqrt(variance) / pairs, kInfinite, bounds, alpha);
  test.first = test.second = static_cast<size_t>(counts.pairs());
  return test;
}

}  // namespace ocelli
