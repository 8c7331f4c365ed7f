#include "analysis/inference/crossed_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/inference/sample.h"

namespace ocelli {
namespace {

/// A standard error below this share of the contributions' sizes is rounding.
constexpr double kRounding = 1e-10;

double squaresOfSums(const std::vector<double>& values, const DenseLabels& clusters) {
  std::vector<double> sums(clusters.count);
  for (size_t i = 0; i < values.size(); ++i) {
    sums[clusters.of[i]] += values[i];
  }
  return std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0);
}

}  // namespace

double CrossedClusters::degreesOfFreedom() const {
  const size_t fewer = second.count > 0 ? std::min(first.count, second.count) : first.count;
  return static_cast<double>(fewer) - 1;
}

CrossedClusters crossedClusters(const std::vector<int>& first, const std::vector<int>& second) {
  requireArgument(second.empty() || second.size() == first.size(), "clusters of trials differ in number",
                  "crossedClusters");
  CrossedClusters clusters{denseLabels(first), denseLabels(second), {}};
  std::vector<int> both;
  for (size_t i = 0; i < second.size(); ++i) {
    both.push_back(static_cast<int>(clusters.first.of[i] * clusters.second.count + clusters.second.of[i]));
  }
  clusters.both = denseLabels(both);
  return clusters;
}

double fewClustersFactor(const DenseLabels& clusters, size_t coefficients) {
  const auto count = static_cast<double>(clusters.count);
  return count / std::max(1.0, count - static_cast<double>(coefficients));
}

double clusteredVariance(const std::vector<double>& values, const CrossedClusters& clusters, size_t coefficients) {
  const double byFirst = fewClustersFactor(clusters.first) * squaresOfSums(values, clusters.first);
  if (clusters.second.count == 0) {
    return byFirst;
  }
  const double bySecond = fewClustersFactor(clusters.second, coefficients) * squaresOfSums(values, clusters.second);
  return byFirst + std::max(0.0, bySecond - squaresOfSums(values, clusters.both));
}

Estimable<Estimate> clusteredEstimate(double value, const std::vector<double>& contributions,
                                      const CrossedClusters& clusters, double level, size_t coefficients) {
  if (!(clusters.degreesOfFreedom() > 0)) {
    return Estimable<Estimate>::impossible("there are no two subjects, or no two cases, that could be compared");
  }
  const double variance = clusteredVariance(contributions, clusters, coefficients);
  // Where contributions cancel in every cluster, rounding is left of them.
  const double size = std::accumulate(contributions.begin(), contributions.end(), 0.0,
                                      [](double sum, double each) { return sum + std::abs(each); });
  if (!(std::sqrt(std::max(0.0, variance)) > kRounding * size)) {
    return Estimable<Estimate>::impossible("all subjects and cases have the same difference");
  }
  return waldEstimate(value, std::sqrt(variance), level, clusters.degreesOfFreedom());
}

Estimable<Estimate> clusteredMean(const std::vector<double>& values, const CrossedClusters& clusters, double level) {
  if (values.empty()) {
    return Estimable<Estimate>::impossible("there are no values");
  }
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  std::vector<double> contributions;
  for (const double value : values) {
    contributions.push_back(differenceOf(mean, value) / count);
  }
  return clusteredEstimate(mean, contributions, clusters, level);
}

Estimable<Estimate> clusteredMeanDifference(const std::vector<double>& values, const std::vector<bool>& isSecond,
                                            const std::vector<int>& first, const std::vector<int>& second,
                                            double level) {
  requireArgument(values.size() == isSecond.size() && values.size() == first.size(),
                  "values, kinds and clusters differ in number", "clusteredMeanDifference");
  struct Sums {
    double sum = 0;
    double count = 0;
  };
  const DenseLabels dense = denseLabels(first);
  std::vector<std::array<Sums, 2>> byCluster(dense.count);
  for (size_t i = 0; i < values.size(); ++i) {
    Sums& sums = byCluster[dense.of[i]][isSecond[i]];
    sums.sum += values[i];
    ++sums.count;
  }
  const auto hasBoth = [](const std::array<Sums, 2>& kinds) { return kinds[0].count > 0 && kinds[1].count > 0; };
  const auto clusters = static_cast<double>(std::count_if(byCluster.begin(), byCluster.end(), hasBoth));
  if (clusters == 0) {
    return Estimable<Estimate>::impossible("no subject has trials of both kinds");
  }
  std::array<double, 2> means{};
  for (const std::array<Sums, 2>& kinds : byCluster) {
    for (size_t kind = 0; hasBoth(kinds) && kind < 2; ++kind) {
      means[kind] += kinds[kind].sum / kinds[kind].count / clusters;
    }
  }
  std::vector<double> contributions;
  std::vector<int> keptFirst;
  std::vector<int> keptSecond;
  for (size_t i = 0; i < values.size(); ++i) {
    const std::array<Sums, 2>& kinds = byCluster[dense.of[i]];
    if (!hasBoth(kinds)) {
      continue;
    }
    const double share = differenceOf(means[isSecond[i]], values[i]) / (kinds[isSecond[i]].count * clusters);
    contributions.push_back(isSecond[i] ? share : -share);
    keptFirst.push_back(first[i]);
    if (!second.empty()) {
      keptSecond.push_back(second[i]);
    }
  }
  return clusteredEstimate(differenceOf(means[0], means[1]), contributions, crossedClusters(keptFirst, keptSecond),
                           level, 2);
}

}  // namespace ocelli
