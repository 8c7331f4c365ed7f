#include "analysis/inference/holm.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/inference/wald.h"

namespace ocelli {

std::vector<double> holmAdjusted(const std::vector<double>& pValues) {
  std::vector<size_t> order;
  for (size_t i = 0; i < pValues.size(); ++i) {
    if (!std::isnan(pValues[i])) {
      requireArgument(pValues[i] >= 0 && pValues[i] <= 1, "a number is no p value", "holmAdjusted");
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return pValues[a] < pValues[b]; });
  std::vector<double> adjusted(pValues.size(), kNotKnown);
  double largest = 0;
  for (size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, static_cast<double>(pValues.size() - i) * pValues[order[i]]);
    adjusted[order[i]] = std::min(largest, 1.0);
  }
  return adjusted;
}

std::vector<double> holmAdjusted(const std::vector<FamilyTest>& tests) {
  std::map<std::string, std::vector<size_t>> families;
  for (size_t i = 0; i < tests.size(); ++i) {
    families[tests[i].family].push_back(i);
  }
  std::vector<double> adjusted(tests.size(), kNotKnown);
  for (const auto& [name, members] : families) {
    std::vector<double> pValues;
    for (const size_t i : members) {
      pValues.push_back(tests[i].pValue);
    }
    const std::vector<double> ofFamily = holmAdjusted(pValues);
    for (size_t i = 0; i < members.size(); ++i) {
      adjusted[members[i]] = ofFamily[i];
    }
  }
  return adjusted;
}

}  // namespace ocelli
