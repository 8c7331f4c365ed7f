// How long a stage took the last times it was done, to foresee how long it takes the next time.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace ocelli {

class StageTimes {
 public:
  using Duration = std::chrono::nanoseconds;

  void add(Duration time);
  bool empty() const { return count_ == 0; }
  /// What it will hardly exceed: the worst but one of those kept (the worst, where there are few), as a hiccup comes
  /// once, and half as far again as that is from the median.
  Duration high() const;
  Duration median() const;

 private:
  static constexpr size_t kKept = 32;
  std::array<Duration, kKept> times_{};
  size_t count_ = 0;  ///< that were ever added
};

}  // namespace ocelli
