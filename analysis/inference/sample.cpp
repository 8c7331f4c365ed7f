#include "analysis/inference/sample.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

/// Of sums of some thousand numbers, relative.
constexpr double kSampleRounding = 1e-12;

bool areAlike(double a, double b) {
  return std::abs(a - b) <= kSampleRounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

double differenceOf(double first, double second) {
  return areAlike(first, second) ? 0 : second - first;
}

SampleMoments momentsOf(const std::vector<double>& values) {
  SampleMoments moments;
  moments.count = static_cast<double>(values.size());
  if (values.empty()) {
    return moments;
  }
  moments.mean = std::accumulate(values.begin(), values.end(), 0.0) / moments.count;
  double squares = 0;
  for (const double value : values) {
    squares += (value - moments.mean) * (value - moments.mean);
  }
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  if (values.size() > 1 && !areAlike(*least, *largest)) {
    moments.variance = squares / (moments.count - 1);
  }
  return moments;
}

double medianOfSorted(const std::vector<double>& sorted) {
  const size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

SampleRanks ranksOf(const std::vector<double>& values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return values[a] < values[b]; });
  SampleRanks ranks;
  ranks.of.resize(values.size());
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin;
    while (end < order.size() && areAlike(values[order[end]], values[order[begin]])) {
      ++end;
    }
    for (size_t i = begin; i < end; ++i) {
      ranks.of[order[i]] = static_cast<double>(begin + 1 + end) / 2;
    }
    const auto ties = static_cast<double>(end - begin);
    ranks.tieSum += ties * ties * ties - ties;
    begin = end;
  }
  return ranks;
}

void requireFinite(const std::vector<double>& values, const char* function) {
  requireArgument(std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }),
                  "a value is not finite", function);
}

}  // namespace ocelli
