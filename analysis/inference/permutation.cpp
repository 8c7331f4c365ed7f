#include "analysis/inference/permutation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/base/random_numbers.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

constexpr size_t kAllTurnsUpTo = 20;  // subjects

/// How many of all turns give a sum at least as large as `sum`.
size_t countAllTurns(std::vector<double> means, double least) {
  double sum = std::accumulate(means.begin(), means.end(), 0.0);
  size_t count = std::abs(sum) >= least ? 1 : 0;
  // Each turn differs from the one before by one sign only (Gray's code).
  for (size_t turn = 1; turn < size_t{1} << means.size(); ++turn) {
    double& turned = means[static_cast<size_t>(std::countr_zero(turn))];
    turned = -turned;
    sum += 2 * turned;
    count += std::abs(sum) >= least ? 1 : 0;
  }
  return count;
}

size_t countDrawnTurns(const std::vector<double>& means, double least, size_t turns, uint64_t seed) {
  RandomNumbers random(seed);
  size_t count = 0;
  for (size_t turn = 0; turn < turns; ++turn) {
    double sum = 0;
    uint64_t signs = 0;
    for (size_t i = 0; i < means.size(); ++i) {
      signs = i % 64 == 0 ? random.bits() : signs >> 1;
      sum += (signs & 1) != 0 ? means[i] : -means[i];
    }
    count += std::abs(sum) >= least ? 1 : 0;
  }
  return count;
}

}  // namespace

Estimable<SignFlipTest> signFlipTest(const std::vector<SubjectDifference>& differences, uint64_t seed, size_t turns) {
  std::map<int, std::pair<double, int>> bySubject;
  for (const SubjectDifference& each : differences) {
    requireArgument(std::isfinite(each.difference), "a difference is not finite", "signFlipTest");
    bySubject[each.subject].first += each.difference;
    ++bySubject[each.subject].second;
  }
  requireArgument(turns > 0, "no turn is to be drawn", "signFlipTest");
  if (bySubject.size() < 2) {
    return Estimable<SignFlipTest>::impossible(
        fmt::format("there are {} subjects, and 2 are needed", bySubject.size()));
  }
  std::vector<double> means;
  double size = 0;
  for (const auto& [subject, sum] : bySubject) {
    means.push_back(sum.first / sum.second);
    size += std::abs(means.back());
  }
  if (size == 0) {
    return Estimable<SignFlipTest>::impossible("all differences are 0");
  }
  const double sum = std::accumulate(means.begin(), means.end(), 0.0);
  const double least = std::abs(sum) - 1e-10 * size;  // sums that are equal may differ by rounding
  SignFlipTest test;
  test.subjects = means.size();
  test.mean = sum / static_cast<double>(means.size());
  test.exact = means.size() <= kAllTurnsUpTo;
  if (test.exact) {
    test.turns = size_t{1} << means.size();
    test.pValue = static_cast<double>(countAllTurns(means, least)) / static_cast<double>(test.turns);
  } else {
    test.turns = turns;
    test.pValue = static_cast<double>(countDrawnTurns(means, least, turns, seed) + 1) / static_cast<double>(turns + 1);
  }
  return test;
}

}  // namespace ocelli
