#include "analysis/models/parametric_bootstrap.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What a replicate gives, one after the other; none where it could not be fitted.
using Replicate = std::optional<std::vector<double>>;

/// Coefficients, then standard deviations term by term.
std::vector<double> valuesOf(const MixedModelFit& fit) {
  std::vector<double> values(fit.coefficients.begin(), fit.coefficients.end());
  for (const RandomTermFit& term : fit.random) {
    values.insert(values.end(), term.standardDeviations.begin(), term.standardDeviations.end());
  }
  return values;
}

std::vector<std::vector<double>> replicatesThatWorked(const BootstrapOptions& options,
                                                      const std::function<Replicate(RandomNumbers&)>& draw) {
  std::vector<Replicate> all(static_cast<size_t>(options.replicates));
  tbb::parallel_for(size_t{0}, all.size(), [&](size_t index) {
    RandomNumbers numbers(options.seed, index);
    all[index] = draw(numbers);
  });
  std::vector<std::vector<double>> worked;
  for (Replicate& replicate : all) {
    if (replicate) {
      worked.push_back(std::move(*replicate));
    }
  }
  return worked;
}

bool areEnough(size_t worked, const BootstrapOptions& options) {
  return worked >= 2 && 10 * worked >= 9 * static_cast<size_t>(options.replicates);
}

std::string tooFew(size_t worked, const BootstrapOptions& options) {
  return fmt::format("only {} of {} replicates of the bootstrap could be fitted", worked, options.replicates);
}

/// By linear interpolation between the sorted values.
double quantileOf(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Estimate percentileInterval(double value, std::vector<double> replicates, double level) {
  std::sort(replicates.begin(), replicates.end());
  const Eigen::Map<const Eigen::ArrayXd> array(replicates.data(), static_cast<Index>(replicates.size()));
  Estimate estimate;
  estimate.value = value;
  estimate.standardError =
      std::sqrt((array - array.mean()).square().sum() / static_cast<double>(replicates.size() - 1));
  estimate.lower = quantileOf(replicates, (1 - level) / 2);
  estimate.upper = quantileOf(replicates, (1 + level) / 2);
  return estimate;
}

Estimable<BootstrapIntervals> intervalsOf(const MixedModelFit& fit, const BootstrapOptions& options,
                                          const std::function<Replicate(RandomNumbers&)>& draw) {
  const std::vector<std::vector<double>> worked = replicatesThatWorked(options, draw);
  if (!areEnough(worked.size(), options)) {
    return Estimable<BootstrapIntervals>::impossible(tooFew(worked.size(), options));
  }
  const std::vector<double> values = valuesOf(fit);
  size_t next = 0;
  const auto take = [&] {
    std::vector<double> replicates;
    for (const std::vector<double>& each : worked) {
      replicates.push_back(each[next]);
    }
    const double value = values[next++];
    return percentileInterval(value, std::move(replicates), options.level);
  };
  BootstrapIntervals intervals;
  intervals.replicates = static_cast<int>(worked.size());
  intervals.failed = options.replicates - intervals.replicates;
  for (Index i = 0; i < fit.coefficients.size(); ++i) {
    intervals.coefficients.push_back(take());
  }
  for (const RandomTermFit& term : fit.random) {
    std::vector<Estimate>& estimates = intervals.standardDeviations.emplace_back();
    for (Index i = 0; i < term.standardDeviations.size(); ++i) {
      estimates.push_back(take());
    }
  }
  return intervals;
}

template <class Fit>
bool isGood(const Estimable<Fit>& fit) {
  return fit.isPossible() && fit->convergence.converged;
}

/// `fitSmaller`, `fitLarger`: of a response; `simulate`: one from a fit of the smaller model.
template <class Response, class FitSmaller, class FitLarger, class Simulate>
Estimable<Estimate> ratioOf(const Response& response, const FitSmaller& fitSmaller, const FitLarger& fitLarger,
                            const Simulate& simulate, const BootstrapOptions& options) {
  const auto smaller = fitSmaller(response);
  const auto larger = fitLarger(response);
  if (!smaller || !larger) {
    return Estimable<Estimate>::impossible(smaller ? larger.reason() : smaller.reason());
  }
  const Estimable<Estimate> asymptotic = likelihoodRatio(*smaller, *larger);
  if (!asymptotic) {
    return asymptotic;
  }
  const auto worked = replicatesThatWorked(options, [&](RandomNumbers& numbers) -> Replicate {
    const Response drawn = simulate(*smaller, numbers);
    const auto drawnSmaller = fitSmaller(drawn);
    const auto drawnLarger = fitLarger(drawn);
    if (!isGood(drawnSmaller) || !isGood(drawnLarger)) {
      return std::nullopt;
    }
    return std::vector<double>{drawnSmaller->deviance - drawnLarger->deviance};
  });
  if (!areEnough(worked.size(), options)) {
    return Estimable<Estimate>::impossible(tooFew(worked.size(), options));
  }
  const auto asLarge = std::count_if(worked.begin(), worked.end(), [&](const std::vector<double>& replicate) {
    return replicate[0] >= asymptotic->statistic;
  });
  Estimate estimate = *asymptotic;
  estimate.pValue = static_cast<double>(1 + asLarge) / static_cast<double>(1 + worked.size());
  return estimate;
}

}  // namespace

Estimable<BootstrapIntervals> parametricBootstrap(const LinearMixedModel& model, const LinearMixedFit& fit,
                                                  const BootstrapOptions& options) {
  return intervalsOf(fit, options, [&](RandomNumbers& numbers) -> Replicate {
    const auto again = model.fit(model.simulate(fit, numbers), fit.restricted);
    return isGood(again) ? Replicate(valuesOf(*again)) : std::nullopt;
  });
}

Estimable<BootstrapIntervals> parametricBootstrap(const BinomialMixedModel& model, const BinomialMixedFit& fit,
                                                  const VectorXd& trials, const BootstrapOptions& options) {
  return intervalsOf(fit, options, [&](RandomNumbers& numbers) -> Replicate {
    const auto again = model.fit(model.simulate(fit, trials, numbers), fit.quadraturePoints);
    return isGood(again) ? Replicate(valuesOf(*again)) : std::nullopt;
  });
}

Estimable<Estimate> bootstrapLikelihoodRatio(const BinomialMixedModel& smaller, const BinomialMixedModel& larger,
                                             const BinomialResponse& response, const BootstrapOptions& options) {
  return ratioOf(
      response, [&](const BinomialResponse& each) { return smaller.fit(each); },
      [&](const BinomialResponse& each) { return larger.fit(each); },
      [&](const BinomialMixedFit& fit, RandomNumbers& numbers) {
        return smaller.simulate(fit, response.trials, numbers);
      },
      options);
}

Estimable<Estimate> bootstrapLikelihoodRatio(const LinearMixedModel& smaller, const LinearMixedModel& larger,
                                             const VectorXd& response, const BootstrapOptions& options) {
  return ratioOf(
      response, [&](const VectorXd& each) { return smaller.fit(each, false); },
      [&](const VectorXd& each) { return larger.fit(each, false); },
      [&](const LinearMixedFit& fit, RandomNumbers& numbers) { return smaller.simulate(fit, numbers); }, options);
}

}  // namespace ocelli
