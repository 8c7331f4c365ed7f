#include "analysis/inference/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Above, the normal approximation is used, as everywhere.
constexpr size_t kExactBelow = 50;

/// Probabilities of the sums 0, 1, ... of a rank statistic if there is no effect.
using SumProbabilities = std::vector<double>;

/// Each rank from 1 to `count` is in the sum or not.
SumProbabilities signedRankProbabilities(size_t count) {
  SumProbabilities p = {1};
  for (size_t rank = 1; rank <= count; ++rank) {
    SumProbabilities next(p.size() + rank);
    for (size_t i = 0; i < p.size(); ++i) {
      next[i] += p[i] / 2;
      next[i + rank] += p[i] / 2;
    }
    p = std::move(next);
  }
  return p;
}

/// Pairs in which the second is larger. The largest of all values belongs to the second group, and is then larger than
/// all of the first, or to the first.
SumProbabilities rankSumProbabilities(size_t first, size_t second) {
  // rows[n]: of `m` values in the first group and n in the second.
  std::vector<SumProbabilities> rows(second + 1, SumProbabilities{1});
  for (size_t m = 1; m <= first; ++m) {
    for (size_t n = 1; n <= second; ++n) {
      SumProbabilities next(m * n + 1);
      const auto all = static_cast<double>(m + n);
      const SumProbabilities& fewerFirst = rows[n];
      for (size_t i = 0; i < fewerFirst.size(); ++i) {
        next[i] += fewerFirst[i] * static_cast<double>(m) / all;
      }
      const SumProbabilities& fewerSecond = rows[n - 1];
      for (size_t i = 0; i < fewerSecond.size(); ++i) {
        next[i + m] += fewerSecond[i] * static_cast<double>(n) / all;
      }
      rows[n] = std::move(next);
    }
  }
  return rows[second];
}

double exactP(const SumProbabilities& p, double statistic) {
  const auto sum = static_cast<size_t>(std::lround(statistic));
  const double below = std::accumulate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(sum) + 1, 0.0);
  const double above = std::accumulate(p.begin() + static_cast<std::ptrdiff_t>(sum), p.end(), 0.0);
  return std::min(1.0, 2 * std::min(below, above));
}

/// With a correction for continuity.
double normalZ(double fromMean, double deviation) {
  const double corrected = std::copysign(std::max(std::abs(fromMean) - 0.5, 0.0), fromMean);
  return corrected / deviation;
}

/// How many of the sorted values lie outside the interval on either side, plus 1; 0: there are too few for the level.
size_t exactOrder(const SumProbabilities& p, double level) {
  const double tail = (1 - level) / 2;
  double sum = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    sum += p[i];
    if (sum >= tail) {
      return i;
    }
  }
  return 0;
}

size_t normalOrder(double mean, double deviation, double level) {
  return static_cast<size_t>(std::max(0.0, std::floor(mean - normalQuantile((1 + level) / 2) * deviation)));
}

/// The median of the list, and the interval that its order gives.
Estimate locationOf(std::vector<double> list, size_t order) {
  std::sort(list.begin(), list.end());
  Estimate estimate;
  estimate.value = medianOfSorted(list);
  if (order > 0) {
    estimate.lower = list[order - 1];
    estimate.upper = list[list.size() - order];
  }
  return estimate;
}

}  // namespace

Estimable<SignedRankTest> signedRankTest(const std::vector<double>& values, double level) {
  requireFinite(values, "signedRankTest");
  requireArgument(values.size() * (values.size() + 1) / 2 <= kMaxPairs, "there are too many values", "signedRankTest");
  std::vector<double> sizes;
  std::vector<bool> positive;
  for (const double value : values) {
    if (value != 0) {
      sizes.push_back(std::abs(value));
      positive.push_back(value > 0);
    }
  }
  if (sizes.empty()) {
    return Estimable<SignedRankTest>::impossible(values.empty() ? "there are no values" : "all values are 0");
  }
  const SampleRanks ranks = ranksOf(sizes);
  SignedRankTest test;
  test.count = values.size();
  test.zeros = values.size() - sizes.size();
  for (size_t i = 0; i < sizes.size(); ++i) {
    test.positiveRanks += positive[i] ? ranks.of[i] : 0;
  }
  test.exact = values.size() < kExactBelow && test.zeros == 0 && ranks.tieSum == 0;
  std::vector<double> means;  // of all pairs of values, each with itself too
  means.reserve(values.size() * (values.size() + 1) / 2);
  for (size_t i = 0; i < values.size(); ++i) {
    for (size_t j = i; j < values.size(); ++j) {
      means.push_back((values[i] + values[j]) / 2);
    }
  }
  if (test.exact) {
    const SumProbabilities p = signedRankProbabilities(values.size());
    test.center = locationOf(std::move(means), exactOrder(p, level));
    test.center.pValue = exactP(p, test.positiveRanks);
    return test;
  }
  const auto varianceOf = [&](double n) { return n * (n + 1) * (2 * n + 1) / 24 - ranks.tieSum / 48; };
  const auto all = static_cast<double>(values.size());
  test.center = locationOf(std::move(means), normalOrder(all * (all + 1) / 4, std::sqrt(varianceOf(all)), level));
  const auto ranked = static_cast<double>(sizes.size());
  test.center.statistic = normalZ(test.positiveRanks - ranked * (ranked + 1) / 4, std::sqrt(varianceOf(ranked)));
  test.center.degreesOfFreedom = kInfinite;
  test.center.pValue = twoSidedNormal(test.center.statistic);
  return test;
}

Estimable<RankSumTest> rankSumTest(const std::vector<double>& first, const std::vector<double>& second, double level) {
  requireFinite(first, "rankSumTest");
  requireFinite(second, "rankSumTest");
  requireArgument(first.size() * second.size() <= kMaxPairs, "there are too many values", "rankSumTest");
  if (first.empty() || second.empty()) {
    return Estimable<RankSumTest>::impossible("a group has no values");
  }
  std::vector<double> all = second;
  all.insert(all.end(), first.begin(), first.end());
  const SampleRanks ranks = ranksOf(all);
  const auto m = static_cast<double>(first.size());
  const auto n = static_cast<double>(second.size());
  const double variance = m * n / 12 * (m + n + 1 - ranks.tieSum / ((m + n) * (m + n - 1)));
  if (!(variance > 0)) {
    return Estimable<RankSumTest>::impossible("all values are the same");
  }
  RankSumTest test;
  test.first = first.size();
  test.second = second.size();
  test.statistic =
      std::accumulate(ranks.of.begin(), ranks.of.begin() + static_cast<std::ptrdiff_t>(second.size()), 0.0) -
      n * (n + 1) / 2;
  test.exact = first.size() < kExactBelow && second.size() < kExactBelow && ranks.tieSum == 0;
  std::vector<double> differences;
  differences.reserve(first.size() * second.size());
  for (const double a : first) {
    for (const double b : second) {
      differences.push_back(b - a);
    }
  }
  if (test.exact) {
    const SumProbabilities p = rankSumProbabilities(first.size(), second.size());
    test.shift = locationOf(std::move(differences), exactOrder(p, level));
    test.shift.pValue = exactP(p, test.statistic);
    return test;
  }
  test.shift = locationOf(std::move(differences), normalOrder(m * n / 2, std::sqrt(variance), level));
  test.shift.statistic = normalZ(test.statistic - m * n / 2, std::sqrt(variance));
  test.shift.degreesOfFreedom = kInfinite;
  test.shift.pValue = twoSidedNormal(test.shift.statistic);
  return test;
}

}  // namespace ocelli
