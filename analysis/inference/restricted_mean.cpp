#include "analysis/inference/restricted_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/crossed_clusters.h"

namespace ocelli {
namespace {

/// The area under the curve up to the horizon, and what an event then would take off it.
struct Area {
  double total = 0;
  double variance = 0;            ///< Greenwood's
  std::vector<RiskSet> sets;      ///< before the horizon
  std::vector<double> remaining;  ///< area from that time to the horizon
  size_t events = 0;
};

Area areaUnderCurve(const std::vector<SurvivalTime>& times, double horizon) {
  Area area;
  for (const RiskSet& set : riskSets(times)) {
    if (set.seconds < horizon) {
      area.sets.push_back(set);
      area.events += set.events;
    }
  }
  double survival = 1;
  double from = 0;
  std::vector<double> pieces;  // from each time to the next, or to the horizon
  for (size_t i = 0; i < area.sets.size(); ++i) {
    const RiskSet& set = area.sets[i];
    area.total += survival * (set.seconds - from);
    survival *= static_cast<double>(set.atRisk - set.events) / static_cast<double>(set.atRisk);
    from = set.seconds;
    const double to = i + 1 < area.sets.size() ? area.sets[i + 1].seconds : horizon;
    pieces.push_back(survival * (to - from));
  }
  area.total += survival * (horizon - from);
  area.remaining.resize(pieces.size());
  double remaining = 0;
  for (size_t i = pieces.size(); i-- > 0;) {
    remaining += pieces[i];
    area.remaining[i] = remaining;
    const auto atRisk = static_cast<double>(area.sets[i].atRisk);
    const auto events = static_cast<double>(area.sets[i].events);
    if (remaining > 0) {
      area.variance += remaining * remaining * events / (atRisk * (atRisk - events));
    }
  }
  return area;
}

/// By how much the area grows with the weight of each trial.
std::vector<double> influences(const Area& area, const std::vector<SurvivalTime>& times) {
  // A trial at risk at an event adds area; the trial that had the event takes some away.
  std::vector<double> gained(area.sets.size());
  double sum = 0;
  for (size_t i = 0; i < area.sets.size(); ++i) {
    const auto atRisk = static_cast<double>(area.sets[i].atRisk);
    const auto events = static_cast<double>(area.sets[i].events);
    if (area.remaining[i] > 0) {
      sum += area.remaining[i] * events / (atRisk * (atRisk - events));
    }
    gained[i] = sum;
  }
  std::vector<double> values;
  for (const SurvivalTime& time : times) {
    const auto after = std::upper_bound(area.sets.begin(), area.sets.end(), time.seconds,
                                        [](double seconds, const RiskSet& set) { return seconds < set.seconds; });
    if (after == area.sets.begin()) {
      values.push_back(0);
      continue;
    }
    const size_t last = static_cast<size_t>(after - area.sets.begin()) - 1;
    double value = gained[last];
    const RiskSet& set = area.sets[last];
    if (time.observed && time.seconds == set.seconds && area.remaining[last] > 0) {
      value -= area.remaining[last] / static_cast<double>(set.atRisk - set.events);
    }
    values.push_back(value);
  }
  return values;
}

/// Why the mean of these trials cannot be estimated; empty where it can.
std::string obstacle(const std::vector<SurvivalTime>& times, double horizon, const Area& area) {
  if (times.empty()) {
    return "there are no trials";
  }
  if (area.events == 0) {
    return fmt::format("none of {} trials ended by itself before {:g} s", times.size(), horizon);
  }
  const auto last = std::max_element(
      times.begin(), times.end(), [](const SurvivalTime& a, const SurvivalTime& b) { return a.seconds < b.seconds; });
  const bool allEnded = area.sets.back().events == area.sets.back().atRisk;
  if (last->seconds < horizon && !allEnded) {
    return fmt::format("no trial was watched for longer than {:g} s, so the curve is not known until {:g} s",
                       last->seconds, horizon);
  }
  if (area.variance == 0) {
    return fmt::format("all {} trials ended at the same moment", times.size());
  }
  return {};
}

Estimable<RestrictedMean> restrictedMeanOf(const Area& area, const std::vector<SurvivalTime>& times,
                                           const CrossedClusters& clusters, double level) {
  if (clusters.first.count == 1) {
    return Estimable<RestrictedMean>::impossible("all trials belong to one subject, so subjects cannot be compared");
  }
  if (clusters.second.count == 1) {
    return Estimable<RestrictedMean>::impossible("all trials are of one case, so cases cannot be compared");
  }
  RestrictedMean result;
  result.trials = times.size();
  result.events = area.events;
  result.clusters = clusters.first.count;
  const bool clustered = clusters.first.count > 0;
  const double variance = clustered ? clusteredVariance(influences(area, times), clusters) : area.variance;
  if (!(variance > 0)) {
    return Estimable<RestrictedMean>::impossible("all subjects have the same mean");
  }
  result.mean =
      waldEstimate(area.total, std::sqrt(variance), level, clustered ? clusters.degreesOfFreedom() : kInfinite);
  result.mean.pValue = kNotKnown;
  result.mean.statistic = kNotKnown;
  return result;
}

void checkArguments(const std::vector<SurvivalTime>& times, double horizon, const std::vector<int>& clusters,
                    const char* function) {
  checkTimes(times, function);
  requireArgument(std::isfinite(horizon) && horizon > 0, "the horizon is not positive", function);
  requireArgument(clusters.empty() || clusters.size() == times.size(), "clusters and trials differ in number",
                  function);
}

}  // namespace

Estimable<RestrictedMean> restrictedMean(const std::vector<SurvivalTime>& times, double horizon,
                                         const std::vector<int>& clusters, double level,
                                         const std::vector<int>& items) {
  checkArguments(times, horizon, clusters, "restrictedMean");
  const Area area = areaUnderCurve(times, horizon);
  if (const std::string reason = obstacle(times, horizon, area); !reason.empty()) {
    return Estimable<RestrictedMean>::impossible(reason);
  }
  return restrictedMeanOf(area, times, crossedClusters(clusters, items), level);
}

Estimable<RestrictedMeanDifference> restrictedMeanDifference(const std::vector<SurvivalTime>& times,
                                                             const std::vector<bool>& isSecond, double horizon,
                                                             const std::vector<int>& clusters, double level,
                                                             const std::vector<int>& items) {
  checkArguments(times, horizon, clusters, "restrictedMeanDifference");
  requireArgument(isSecond.size() == times.size(), "groups and trials differ in number", "restrictedMeanDifference");
  using Result = Estimable<RestrictedMeanDifference>;
  const CrossedClusters crossed = crossedClusters(clusters, items);
  RestrictedMeanDifference result;
  std::vector<double> values(times.size());
  double variance = 0;
  for (const bool second : {false, true}) {
    std::vector<SurvivalTime> group;
    std::vector<int> groupClusters;
    std::vector<int> groupItems;
    std::vector<size_t> rows;
    for (size_t i = 0; i < times.size(); ++i) {
      if (isSecond[i] == second) {
        rows.push_back(i);
        group.push_back(times[i]);
        if (!clusters.empty()) {
          groupClusters.push_back(clusters[i]);
        }
        if (!items.empty()) {
          groupItems.push_back(items[i]);
        }
      }
    }
    const Estimable<RestrictedMean> mean = restrictedMean(group, horizon, groupClusters, level, groupItems);
    if (!mean) {
      return Result::impossible(fmt::format("in the {} group, {}", second ? "second" : "first", mean.reason()));
    }
    (second ? result.second : result.first) = *mean;
    const Area area = areaUnderCurve(group, horizon);
    variance += area.variance;
    const std::vector<double> groupValues = influences(area, group);
    for (size_t i = 0; i < rows.size(); ++i) {
      values[rows[i]] = second ? groupValues[i] : -groupValues[i];
    }
  }
  const bool clustered = crossed.first.count > 0;
  const double difference = result.second.mean.value - result.first.mean.value;
  const double standardError = std::sqrt(clustered ? clusteredVariance(values, crossed) : variance);
  if (!(standardError > 0)) {
    return Result::impossible("the difference is the same in all subjects");
  }
  result.difference =
      waldEstimate(difference, standardError, level, clustered ? crossed.degreesOfFreedom() : kInfinite);
  return result;
}

}  // namespace ocelli
