#include "analysis/inference/effect_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"
#include "analysis/inference/wilcoxon.h"

namespace ocelli {
namespace {

/// The noncentrality with which t is exceeded with this chance. P(T <= t) falls with it.
double noncentralityOf(double t, double degreesOfFreedom, double probability) {
  double lower = t - 1;
  double upper = t + 1;
  for (double step = 1; noncentralStudentProbability(t, degreesOfFreedom, lower) < probability; step *= 2) {
    lower -= step;
  }
  for (double step = 1; noncentralStudentProbability(t, degreesOfFreedom, upper) > probability; step *= 2) {
    upper += step;
  }
  while (upper - lower > 1e-11 * (1 + std::abs(upper))) {
    const double middle = (lower + upper) / 2;
    (noncentralStudentProbability(t, degreesOfFreedom, middle) > probability ? lower : upper) = middle;
  }
  return (lower + upper) / 2;
}

/// d = t / root, with its interval.
Estimate standardized(double t, double degreesOfFreedom, double root, double level) {
  Estimate d;
  d.value = t / root;
  d.lower = noncentralityOf(t, degreesOfFreedom, (1 + level) / 2) / root;
  d.upper = noncentralityOf(t, degreesOfFreedom, (1 - level) / 2) / root;
  d.statistic = t;
  d.degreesOfFreedom = degreesOfFreedom;
  d.pValue = twoSidedStudent(t, degreesOfFreedom);
  return d;
}

Estimate scaled(Estimate estimate, double factor) {
  estimate.value *= factor;
  estimate.lower *= factor;
  estimate.upper *= factor;
  return estimate;
}

double hedgesCorrection(double degreesOfFreedom) {
  return std::exp(logGamma(degreesOfFreedom / 2) - logGamma((degreesOfFreedom - 1) / 2)) *
         std::sqrt(2 / degreesOfFreedom);
}

/// Why there is no ratio; empty where there may be one.
std::string obstacle(const Share& first, const Share& second) {
  return first.trials == 0 || second.trials == 0 ? "a group has no trials" : "";
}

}  // namespace

Estimable<PairedEffect> pairedEffect(const std::vector<double>& first, const std::vector<double>& second,
                                     double level) {
  requireArgument(first.size() == second.size(), "the conditions differ in length", "pairedEffect");
  requireFinite(first, "pairedEffect");
  requireFinite(second, "pairedEffect");
  if (first.size() < 2) {
    return Estimable<PairedEffect>::impossible(fmt::format("there are {} pairs, and 2 are needed", first.size()));
  }
  std::vector<double> differences;
  for (size_t i = 0; i < first.size(); ++i) {
    differences.push_back(differenceOf(first[i], second[i]));
  }
  const SampleMoments moments = momentsOf(differences);
  if (moments.variance == 0) {
    return Estimable<PairedEffect>::impossible("all differences are the same");
  }
  const double deviation = std::sqrt(moments.variance);
  const double averageDeviation = (std::sqrt(momentsOf(first).variance) + std::sqrt(momentsOf(second).variance)) / 2;
  const double root = std::sqrt(moments.count);
  const double correction = first.size() > 2 ? hedgesCorrection(moments.count - 1) : kNotKnown;
  PairedEffect effect;
  effect.pairs = first.size();
  effect.dz = standardized(moments.mean / deviation * root, moments.count - 1, root, level);
  effect.dav = scaled(effect.dz, deviation / averageDeviation);
  effect.correctedDz = scaled(effect.dz, correction);
  effect.correctedDav = scaled(effect.dav, correction);
  return effect;
}

Estimable<GroupEffect> groupEffect(const std::vector<double>& first, const std::vector<double>& second, double level) {
  requireFinite(first, "groupEffect");
  requireFinite(second, "groupEffect");
  if (first.size() < 2 || second.size() < 2) {
    return Estimable<GroupEffect>::impossible(
        fmt::format("the groups have {} and {} values, and 2 in each are needed", first.size(), second.size()));
  }
  const SampleMoments a = momentsOf(first);
  const SampleMoments b = momentsOf(second);
  const double df = a.count + b.count - 2;
  const double pooled = ((a.count - 1) * a.variance + (b.count - 1) * b.variance) / df;
  if (pooled == 0) {
    return Estimable<GroupEffect>::impossible("in each group all values are the same");
  }
  const double root = std::sqrt(a.count * b.count / (a.count + b.count));
  GroupEffect effect;
  effect.first = first.size();
  effect.second = second.size();
  effect.d = standardized((b.mean - a.mean) / std::sqrt(pooled) * root, df, root, level);
  effect.correctedD = scaled(effect.d, hedgesCorrection(df));
  return effect;
}

Estimable<Estimate> oddsRatio(const Share& first, const Share& second, double level) {
  if (const std::string reason = obstacle(first, second); !reason.empty()) {
    return Estimable<Estimate>::impossible(reason);
  }
  const double a = second.successes, b = second.trials - second.successes;
  const double c = first.successes, d = first.trials - first.successes;
  if (std::min({a, b, c, d}) == 0) {
    return Estimable<Estimate>::impossible("in one group all trials have the same outcome");
  }
  return asRatio(waldEstimate(std::log(a / b) - std::log(c / d), std::sqrt(1 / a + 1 / b + 1 / c + 1 / d), level));
}

Estimable<Estimate> riskRatio(const Share& first, const Share& second, double level) {
  if (const std::string reason = obstacle(first, second); !reason.empty()) {
    return Estimable<Estimate>::impossible(reason);
  }
  if (first.successes == 0 || second.successes == 0) {
    return Estimable<Estimate>::impossible("one group has no success");
  }
  const double a = second.successes, m = second.trials;
  const double c = first.successes, n = first.trials;
  const double variance = 1 / a - 1 / m + 1 / c - 1 / n;
  if (!(variance > 0)) {
    return Estimable<Estimate>::impossible("all trials of both groups are successes");
  }
  return asRatio(waldEstimate(std::log(a / m) - std::log(c / n), std::sqrt(variance), level));
}

Estimable<Estimate> riskDifference(const Share& first, const Share& second, double level) {
  if (const std::string reason = obstacle(first, second); !reason.empty()) {
    return Estimable<Estimate>::impossible(reason);
  }
  const Estimate a = wilsonShare(first, level);
  const Estimate b = wilsonShare(second, level);
  Estimate difference;
  difference.value = b.value - a.value;
  difference.lower = difference.value - std::hypot(b.value - b.lower, a.upper - a.value);
  difference.upper = difference.value + std::hypot(b.upper - b.value, a.value - a.lower);
  return difference;
}

Estimable<Estimate> cliffsDelta(const std::vector<double>& first, const std::vector<double>& second, double level) {
  requireFinite(first, "cliffsDelta");
  requireFinite(second, "cliffsDelta");
  if (first.size() < 2 || second.size() < 2) {
    return Estimable<Estimate>::impossible(
        fmt::format("the groups have {} and {} values, and 2 in each are needed", first.size(), second.size()));
  }
  const auto m = static_cast<double>(first.size());
  const auto n = static_cast<double>(second.size());
  // The mean dominance of each value over the other group, and of their squares over all pairs.
  std::vector<double> ofFirst(first.size()), ofSecond(second.size());
  double delta = 0, squares = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    for (size_t j = 0; j < second.size(); ++j) {
      const double dominance = (second[j] > first[i] ? 1 : 0) - (second[j] < first[i] ? 1 : 0);
      ofFirst[i] += dominance / n;
      ofSecond[j] += dominance / m;
      delta += dominance / (m * n);
      squares += dominance * dominance;
    }
  }
  Estimate estimate;
  estimate.value = delta;
  const double spread = 1 - delta * delta;
  if (spread < 1e-12) {
    return estimate;
  }
  const auto around = [&](const std::vector<double>& dominances) {
    double sum = 0;
    for (const double dominance : dominances) {
      sum += (dominance - delta) * (dominance - delta);
    }
    return sum;
  };
  const double variance =
      std::max((n * n * around(ofFirst) + m * m * around(ofSecond) - (squares - m * n * delta * delta)) /
                   (m * n * (m - 1) * (n - 1)),
               spread / (m * n - 1));
  const double z = normalQuantile((1 + level) / 2);
  const double center = delta - delta * delta * delta;
  const double width = z * std::sqrt(variance * (spread * spread + z * z * variance));
  estimate.standardError = std::sqrt(variance);
  estimate.lower = (center - width) / (spread + z * z * variance);
  estimate.upper = (center + width) / (spread + z * z * variance);
  return estimate;
}

Estimable<Estimate> matchedRankBiserial(const std::vector<double>& differences, double level) {
  const Estimable<SignedRankTest> test = signedRankTest(differences, level);
  if (!test) {
    return Estimable<Estimate>::impossible(test.reason());
  }
  const auto n = static_cast<double>(test->count - test->zeros);
  const double all = n * (n + 1) / 2;
  Estimate estimate;
  estimate.value = 2 * test->positiveRanks / all - 1;
  estimate.pValue = test->center.pValue;
  if (std::abs(estimate.value) < 1 - 1e-12) {
    const double error = std::sqrt(n * (n + 1) * (2 * n + 1) / 6) / all;
    const double width = normalQuantile((1 + level) / 2) * error;
    estimate.lower = std::tanh(std::atanh(estimate.value) - width);
    estimate.upper = std::tanh(std::atanh(estimate.value) + width);
  }
  return estimate;
}

}  // namespace ocelli
