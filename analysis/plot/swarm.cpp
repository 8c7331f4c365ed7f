#include "analysis/plot/swarm.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ocelli {
namespace {

/// The number nearest to 0 that lies in none of the open intervals, which get sorted.
double nearestFree(std::vector<std::pair<double, double>>& taken) {
  constexpr double kTouching = 1e-9;  // intervals that merely touch leave room
  std::sort(taken.begin(), taken.end());
  for (size_t i = 0; i < taken.size();) {
    auto [low, high] = taken[i];
    for (++i; i < taken.size() && taken[i].first < high - kTouching; ++i) {
      high = std::max(high, taken[i].second);
    }
    if (low < -kTouching && high > kTouching) {
      return high <= -low ? high : low;
    }
  }
  return 0;
}

}  // namespace

std::vector<double> swarmOffsets(const std::vector<double>& places, double diameter, double halfWidth) {
  std::vector<size_t> order(places.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return places[a] < places[b]; });
  std::vector<double> offsets(places.size(), 0);
  size_t near = 0;  // the first in order that may touch the next
  double widest = 0;
  std::vector<std::pair<double, double>> taken;
  for (size_t i = 0; i < order.size(); ++i) {
    const double place = places[order[i]];
    while (places[order[near]] < place - diameter) {
      ++near;
    }
    taken.clear();
    for (size_t k = near; k < i; ++k) {
      const double along = place - places[order[k]];
      const double across = std::sqrt(std::max(diameter * diameter - along * along, 0.0));
      taken.emplace_back(offsets[order[k]] - across, offsets[order[k]] + across);
    }
    offsets[order[i]] = nearestFree(taken);
    widest = std::max(widest, std::abs(offsets[order[i]]));
  }
  if (widest > halfWidth) {
    for (double& offset : offsets) {
      offset *= halfWidth / widest;
    }
  }
  return offsets;
}

std::vector<size_t> drawnPoints(const std::vector<double>& values, size_t most) {
  std::vector<size_t> order;
  for (size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) {
      order.push_back(i);
    }
  }
  if (order.size() <= most) {
    return order;
  }
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return values[a] < values[b]; });
  std::vector<size_t> drawn;
  for (size_t i = 0; i < most; ++i) {
    drawn.push_back(order[i * (order.size() - 1) / (most - 1)]);
  }
  return drawn;
}

}  // namespace ocelli
