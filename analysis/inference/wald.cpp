#include "analysis/inference/wald.h"

#include <cmath>
#include <unordered_map>

#include "analysis/base/distributions.h"
#include "oc_core/base/error.h"

namespace ocelli {

Estimate waldEstimate(double value, double standardError, double level, double degreesOfFreedom, double null) {
  if (std::isnan(standardError)) {
    Estimate estimate;
    estimate.value = value;
    return estimate;
  }
  const double width = studentQuantile((1 + level) / 2, degreesOfFreedom) * standardError;
  const double statistic = (value - null) / standardError;
  return {value,
          standardError,
          value - width,
          value + width,
          statistic,
          degreesOfFreedom,
          twoSidedStudent(statistic, degreesOfFreedom)};
}

Estimate asRatio(const Estimate& logarithm) {
  Estimate ratio = logarithm;
  ratio.value = std::exp(logarithm.value);
  ratio.standardError = ratio.value * logarithm.standardError;
  ratio.lower = std::exp(logarithm.lower);
  ratio.upper = std::exp(logarithm.upper);
  return ratio;
}

Estimate chiSquaredEstimate(double statistic, double degreesOfFreedom) {
  Estimate estimate;
  estimate.value = statistic;
  estimate.statistic = statistic;
  estimate.degreesOfFreedom = degreesOfFreedom;
  estimate.pValue = chiSquaredTail(statistic, degreesOfFreedom);
  return estimate;
}

void requireArgument(bool holds, const std::string& what, const char* function) {
  if (!holds) {
    throw InputError(what, function, "check the table that it was called with");
  }
}

DenseLabels denseLabels(const std::vector<int>& labels) {
  DenseLabels dense;
  std::unordered_map<int, size_t> indices;
  dense.of.reserve(labels.size());
  for (const int label : labels) {
    dense.of.push_back(indices.emplace(label, indices.size()).first->second);
  }
  dense.count = indices.size();
  return dense;
}

}  // namespace ocelli
