#include "display_driver/pacing/stage_times.h"

#include <algorithm>

namespace ocelli {
namespace {

/// With fewer the worst one is no exception yet.
constexpr size_t kFew = 8;

}  // namespace

void StageTimes::add(Duration time) {
  times_[count_++ % kKept] = std::max(time, Duration(0));
}

StageTimes::Duration StageTimes::high() const {
  auto sorted = times_;
  const size_t count = std::min(count_, kKept);
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  if (count == 0) {
    return Duration(0);
  }
  const Duration worst = sorted[count < kFew ? count - 1 : count - 2];
  return worst + (worst - sorted[count / 2]) / 2;
}

StageTimes::Duration StageTimes::median() const {
  auto sorted = times_;
  const size_t count = std::min(count_, kKept);
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return sorted[count / 2];
}

}  // namespace ocelli
