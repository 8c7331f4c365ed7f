#include "analysis/inference/student.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"

namespace ocelli {

Estimable<Estimate> studentMean(const std::vector<double>& values, double level) {
  requireFinite(values, "studentMean");
  if (values.size() < 2) {
    return Estimable<Estimate>::impossible(fmt::format("there are {} values, and 2 are needed", values.size()));
  }
  const SampleMoments moments = momentsOf(values);
  if (moments.variance == 0) {
    return Estimable<Estimate>::impossible(fmt::format("all {} values are the same", values.size()));
  }
  return waldEstimate(moments.mean, std::sqrt(moments.variance / moments.count), level, moments.count - 1);
}

Estimable<Estimate> welchDifference(const std::vector<double>& first, const std::vector<double>& second, double level) {
  requireFinite(first, "welchDifference");
  requireFinite(second, "welchDifference");
  if (first.size() < 2 || second.size() < 2) {
    return Estimable<Estimate>::impossible(
        fmt::format("the groups have {} and {} values, and 2 in each are needed", first.size(), second.size()));
  }
  const SampleMoments a = momentsOf(first);
  const SampleMoments b = momentsOf(second);
  const double squareA = a.variance / a.count;
  const double squareB = b.variance / b.count;
  if (squareA + squareB == 0) {
    return Estimable<Estimate>::impossible("in each group all values are the same");
  }
  const double degrees = (squareA + squareB) * (squareA + squareB) /
                         (squareA * squareA / (a.count - 1) + squareB * squareB / (b.count - 1));
  return waldEstimate(b.mean - a.mean, std::sqrt(squareA + squareB), level, degrees);
}

}  // namespace ocelli
