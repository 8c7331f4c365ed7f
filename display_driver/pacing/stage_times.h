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
  /// All but the worst of those kept (and the worst, where there are few): hiccups count for once.
  Duration high() const;
  Duration median() const;

 private:
  static constexpr size_t kKept = 32;
  std::array<Duration, kKept> times_{};
  size_t count_ = 0;  ///< that were ever added
};

}  // namespace ocelli
