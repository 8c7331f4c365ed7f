#include "analysis/inference/kaplan_meier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/inference/distributions.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Of shares that are counted by different ways.
constexpr double kTolerance = 1e-10;

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

Estimable<SurvivalCurve> survivalCurve(const std::vector<SurvivalTime>& times, double level) {
  checkTimes(times, "survivalCurve");
  if (times.empty()) {
    return Estimable<SurvivalCurve>::impossible("there are no trials");
  }
  SurvivalCurve curve;
  curve.trials = times.size();
  const double z = normalQuantile((1 + level) / 2);
  double survival = 1;
  double greenwood = 0;  // the variance of log S
  for (const RiskSet& set : riskSets(times)) {
    const auto atRisk = static_cast<double>(set.atRisk);
    const auto events = static_cast<double>(set.events);
    survival *= (atRisk - events) / atRisk;
    greenwood += events / (atRisk * (atRisk - events));
    curve.events += set.events;
    SurvivalStep step;
    step.riskSet = set;
    step.survival = survival;
    step.standardError = survival > 0 ? survival * std::sqrt(greenwood) : kNotKnown;
    if (survival > 0 && survival < 1) {
      const double width = z * std::sqrt(greenwood) / std::log(survival);
      const double center = std::log(-std::log(survival));
      step.lower = std::exp(-std::exp(center - width));
      step.upper = std::exp(-std::exp(center + width));
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
  estimate.lower = halfTime(curve, [](const SurvivalStep& step) { return step.lower; }).value_or(kNotKnown);
  estimate.upper = halfTime(curve, [](const SurvivalStep& step) { return step.upper; }).value_or(kInfinite);
  return estimate;
}

}  // namespace ocelli
