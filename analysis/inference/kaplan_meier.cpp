#include "analysis/inference/kaplan_meier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/base/distributions.h"
#include "analysis/inference/crossed_clusters.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Of shares that are counted by different ways.
constexpr double kTolerance = 1e-10;
/// Of a variance by clusters in Greenwood's: below it stands rounding, as where all subjects have the same times.
constexpr double kMinClusteredShare = 1e-12;

/// The variance of log S as time goes on: the values of the infinitesimal jackknife, one a trial, summed by cluster.
class ClusteredVariance {
 public:
  ClusteredVariance(const std::vector<SurvivalTime>& times, const CrossedClusters& clusters)
      : times_(times), clusters_(clusters), values_(times.size()) {}

  /// After the events of a set; sets come in ascending order.
  double after(const RiskSet& set) {
    const auto atRisk = static_cast<double>(set.atRisk);
    const auto left = static_cast<double>(set.atRisk - set.events);
    // log S changes with the weight of who was at risk by 1/left - 1/atRisk, of who had the event by -1/atRisk.
    for (size_t i = 0; i < times_.size() && set.events > 0; ++i) {
      if (times_[i].seconds >= set.seconds) {
        const bool ended = times_[i].observed && times_[i].seconds == set.seconds;
        values_[i] += (ended ? 0 : 1 / left) - 1 / atRisk;
      }
    }
    return clusteredVariance(values_, clusters_);
  }

 private:
  const std::vector<SurvivalTime>& times_;
  const CrossedClusters& clusters_;
  std::vector<double> values_;
};

/// On the scale log(-log S). `error`: of log S.
void addBand(SurvivalStep& step, double error, double quantile) {
  step.standardError = step.survival * error;
  if (step.survival < 1) {
    const double width = quantile * error / std::log(step.survival);
    const double center = std::log(-std::log(step.survival));
    step.lower = std::exp(-std::exp(center - width));
    step.upper = std::exp(-std::exp(center + width));
  }
}

/// When a falling curve reaches a half. Values that are kNotKnown are passed over.
template <class Value>
std::optional<double> halfTime(const SurvivalCurve& curve, Value value) {
  const auto& steps = curve.steps;
  const auto reached = std::find_if(steps.begin(), steps.end(),
                                    [&](const SurvivalStep& step) { return value(step) <= 0.5 + kTolerance; });
  if (reached == steps.end()) {
    return std::nullopt;
  }
  const auto passed =
      std::find_if(reached, steps.end(), [&](const SurvivalStep& step) { return value(step) < 0.5 - kTolerance; });
  const SurvivalStep& end = passed == steps.end() ? steps.back() : *passed;
  return value(*reached) < 0.5 - kTolerance ? reached->riskSet.seconds
                                            : (reached->riskSet.seconds + end.riskSet.seconds) / 2;
}

}  // namespace

Estimable<SurvivalCurve> survivalCurve(const std::vector<SurvivalTime>& times, double level,
                                       const std::vector<int>& clusters, const std::vector<int>& items) {
  checkTimes(times, "survivalCurve");
  requireArgument(clusters.empty() || clusters.size() == times.size(), "clusters and trials differ in number",
                  "survivalCurve");
  if (times.empty()) {
    return Estimable<SurvivalCurve>::impossible("there are no trials");
  }
  SurvivalCurve curve;
  curve.trials = times.size();
  const CrossedClusters crossed = crossedClusters(clusters, items);
  const bool isClustered = crossed.first.count > 0;
  if (isClustered && !(crossed.degreesOfFreedom() > 0)) {
    curve.noBands = crossed.first.count == 1 ? "all trials belong to one subject, so subjects cannot be compared"
                                             : "all trials are of one case, so cases cannot be compared";
  }
  const bool hasBands = curve.noBands.empty();
  const double quantile =
      hasBands ? studentQuantile((1 + level) / 2, isClustered ? crossed.degreesOfFreedom() : kInfinite) : kNotKnown;
  ClusteredVariance clustered(times, crossed);
  double survival = 1;
  double greenwood = 0;  // the variance of log S of independent trials
  for (const RiskSet& set : riskSets(times)) {
    const auto atRisk = static_cast<double>(set.atRisk);
    const auto events = static_cast<double>(set.events);
    survival *= (atRisk - events) / atRisk;
    greenwood += events / (atRisk * (atRisk - events));
    curve.events += set.events;
    SurvivalStep step;
    step.riskSet = set;
    step.survival = survival;
    step.standardError = kNotKnown;
    if (survival > 0 && hasBands) {
      const double variance = isClustered ? clustered.after(set) : greenwood;
      if (variance >= kMinClusteredShare * greenwood) {
        addBand(step, std::sqrt(variance), quantile);
      }
    }
    curve.steps.push_back(step);
  }
  return curve;
}

Estimable<Estimate> medianTime(const SurvivalCurve& curve) {
  const auto median = halfTime(curve, [](const SurvivalStep& step) { return step.survival; });
  if (!median) {
    return Estimable<Estimate>::impossible(
        fmt::format("only {} of {} trials ended, so the curve never falls to a half", curve.events, curve.trials));
  }
  Estimate estimate;
  estimate.value = *median;
  if (!curve.noBands.empty()) {
    return estimate;
  }
  estimate.lower = halfTime(curve, [](const SurvivalStep& step) { return step.lower; }).value_or(kNotKnown);
  estimate.upper = halfTime(curve, [](const SurvivalStep& step) { return step.upper; }).value_or(kInfinite);
  return estimate;
}

}  // namespace ocelli
