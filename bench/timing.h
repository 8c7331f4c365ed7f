// Times a piece of work again and again.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace ocelli {

template <class Work>
double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Of `runs` runs, after one run that is not counted.
template <class Work>
double medianMilliseconds(int runs, const Work& work) {
  work();
  std::vector<double> times(static_cast<size_t>(runs));
  std::generate(times.begin(), times.end(), [&] { return milliseconds(work); });
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<size_t>(runs / 2)];
}

}  // namespace ocelli
