#include "study/live/time_left.h"

#include <algorithm>

namespace ocelli {

void TimeLeft::trialCompleted(int64_t nanoseconds) {
  if (last_) {
    intervals_.push_back(static_cast<double>(nanoseconds - *last_) * 1e-9);
  }
  last_ = nanoseconds;
}

double TimeLeft::seconds(int trials) const {
  if (!knowsPace()) {
    return trials * typicalSeconds_;
  }
  std::vector<double> sorted = intervals_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return trials * *middle;
}

}  // namespace ocelli
