// Times a piece of work again and again.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace ocelli {

template <class Work>
double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Of the CPU, all threads together: what other work on the machine disturbs less.
template <class Work>
double processorMilliseconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) * 1000 / CLOCKS_PER_SEC;
}

/// The least of `runs` runs, after one run that is not counted: what other work on the machine disturbs the least.
template <class Work>
double leastMilliseconds(int runs, const Work& work) {
  work();
  double least = milliseconds(work);
  for (int i = 1; i < runs; ++i) {
    least = std::min(least, milliseconds(work));
  }
  return least;
}

/// The median of `runs` runs, after one run that is not counted.
template <class Work>
double medianMilliseconds(int runs, const Work& work) {
  work();
  std::vector<double> times(static_cast<size_t>(runs));
  std::generate(times.begin(), times.end(), [&] { return milliseconds(work); });
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<size_t>(runs / 2)];
}

}  // namespace ocelli
