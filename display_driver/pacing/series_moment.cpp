#include "display_driver/pacing/series_moment.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

std::optional<size_t> seriesMoment(std::span<const double> times, double seconds, const MotionPlayback& playback) {
  if (times.size() < 2) {
    return 0;
  }
  const auto count = static_cast<double>(times.size());
  const double length = (times.back() - times.front()) * count / (count - 1);
  double passed = seconds * playback.speed;
  if (passed >= length && !playback.loop) {
    return std::nullopt;
  }
  passed -= std::floor(passed / length) * length;
  const auto next = std::ranges::upper_bound(times, times.front() + passed);
  return static_cast<size_t>(std::max<std::ptrdiff_t>(next - times.begin() - 1, 0));
}

}  // namespace ocelli
